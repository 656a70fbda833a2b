// SPDX-License-Identifier: MIT
#include "estimation/navigation/sensor_agreement.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/frames.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// What is wrong with a vehicle that circles while it goes down and up, in a current.
struct Wrong {
  double heading = 1.0, depth = 1.0;                    ///< times what is true
  Eigen::Matrix2d dvl = Eigen::Matrix2d::Identity();    ///< of what it measures, level
  double thrust = 1.0;                                  ///< true speed over what is believed
  Eigen::Vector2d current_W = Eigen::Vector2d::Zero();  ///< [m/s]
  double turn_rate = 0.15;                              ///< [rad/s]
  double heading_noise = 0.01, depth_noise = 0.02, velocity_noise = 0.01;
};

std::vector<std::string> FoundIn(const Wrong& wrong, double seconds = 300.0) {
  SensorAgreement agreement(Meters(0.01));
  Random random(11);
  for (int i = 0; i < 20.0 * seconds; ++i) {
    const double t = 50.0 + 0.05 * i, yaw = wrong.turn_rate * t;
    agreement.AddHeadings(
        t, {.gyro = yaw, .compass = wrong.heading * yaw + random.Normal(wrong.heading_noise)});
    if (i % 4 != 0) continue;
    const double w = 0.15 * (std::sin(0.1 * t) > 0.0 ? 1.0 : -1.0);
    const double depth = 5.0 + 0.15 * std::abs(std::remainder(0.1 * t, 2.0 * M_PI)) / 0.1;
    agreement.AddDive(t, {.v_down = w + random.Normal(wrong.velocity_noise),
                          .depth = wrong.depth * depth + random.Normal(wrong.depth_noise)});
    const Eigen::Vector2d driven(0.5, 0.05 * std::sin(0.3 * t));
    const Eigen::Vector2d over_ground =
        wrong.thrust * driven + Eigen::Rotation2Dd(-yaw) * wrong.current_W;
    agreement.AddDrive(t, driven, wrong.dvl * over_ground);
  }
  std::vector<std::string> motions;
  for (const Disagreement& one : agreement.Found())
    motions.emplace_back(one.what);
  return motions;
}

TEST(SensorAgreement, IsThatOfASoundVehicleWhateverTheWaterAndTheThrust) {
  EXPECT_THAT(FoundIn({}), IsEmpty());
  for (const double thrust : {0.7, 1.4}) {
    for (const double turn_rate : {0.0, 0.15}) {
      for (const double direction : {0.0, 1.5, 3.0, 4.5}) {
        const Eigen::Vector2d current_W =
            0.5 * 0.5 * thrust * Eigen::Vector2d(std::cos(direction), std::sin(direction));
        EXPECT_THAT(FoundIn({.thrust = thrust, .current_W = current_W, .turn_rate = turn_rate}),
                    IsEmpty())
            << thrust << ", " << turn_rate << ", " << direction;
      }
    }
  }
}

TEST(SensorAgreement, OfSensorsThatAreTwiceAsNoisyIsNotDoubted) {
  EXPECT_THAT(FoundIn({.heading_noise = 0.03, .depth_noise = 0.04, .velocity_noise = 0.02}),
              IsEmpty());
}

TEST(SensorAgreement, AHeadingThatTurnsTheOtherWayOrInDegreesOrNotAtAllIsFound) {
  for (const double share : {-1.0, 57.3, 1.0 / 57.3, 0.0})
    EXPECT_THAT(FoundIn({.heading = share}), ElementsAre("TURN")) << share;
}

TEST(SensorAgreement, ADepthThatGrowsUpwardsOrInAnotherUnitIsFound) {
  for (const double share : {-1.0, 100.0, 0.1, 3.28})
    EXPECT_THAT(FoundIn({.depth = share}), ElementsAre("DIVE")) << share;
}

TEST(SensorAgreement, ADvlThatIsTurnedOrTellsAnotherUnitIsFound) {
  const Eigen::Matrix2d quarter = Eigen::Rotation2Dd(0.5 * M_PI).toRotationMatrix();
  for (const Eigen::Matrix2d& dvl : {Eigen::Matrix2d(-Eigen::Matrix2d::Identity()), quarter,
                                     Eigen::Matrix2d(quarter.transpose()),
                                     Eigen::Matrix2d(100.0 * Eigen::Matrix2d::Identity())}) {
    for (const double current : {0.0, 0.15})
      EXPECT_THAT(FoundIn({.dvl = dvl, .current_W = {current, 0.0}}), ElementsAre("DRIVE")) << dvl;
  }
}

TEST(SensorAgreement, AHeadingThatCountsFromEastOrCounterClockwiseIsFoundAtTheSurface) {
  /// On a square of 40 m with fixes of 0.5 m, five minutes and ten.
  const auto found_with = [](double sign, double from, double noise) {
    SensorAgreement agreement(Meters(0.01));
    Random random(5);
    Eigen::Vector2d p_W = Eigen::Vector2d::Zero(), track_D = p_W;
    for (int t = 0; t < 600; ++t) {
      const double heading = 0.5 * M_PI * (t / 80);
      const double believed = from + sign * heading;
      p_W += 0.5 * Eigen::Vector2d(std::cos(heading), std::sin(heading));
      track_D += 0.5 * Eigen::Vector2d(std::cos(believed), std::sin(believed));
      const Eigen::Vector2d off(random.Normal(noise), random.Normal(noise));
      agreement.AddFix(t, p_W + off, 0.5, track_D);
    }
    return agreement.Found();
  };
  EXPECT_THAT(found_with(1.0, 0.0, 0.5), IsEmpty());
  EXPECT_THAT(found_with(1.0, 0.2, 1.5), IsEmpty()) << "a poor compass, fixes thrice as bad";
  for (const auto& [sign, from] : {std::pair(-1.0, 0.5 * M_PI), std::pair(-1.0, 0.0),
                                   std::pair(1.0, 0.5 * M_PI), std::pair(1.0, M_PI)}) {
    const auto found = found_with(sign, from, 0.5);
    ASSERT_EQ(found.size(), 1U) << sign << ", " << from;
    EXPECT_EQ(found[0].what, "WAY");
  }
}

TEST(SensorAgreement, SaysHowFarTheyDisagree) {
  SensorAgreement agreement(Meters(0.01));
  for (int i = 0; i < 2000; ++i)
    agreement.AddHeadings(0.05 * i, {.gyro = 0.005 * i, .compass = WrapAngle(-0.005 * i)});
  ASSERT_EQ(agreement.Found().size(), 1U);
  EXPECT_THAT(agreement.Found()[0].text, HasSubstr("turns -1 times as far as the gyro"));
}

TEST(SensorAgreement, WithoutMotionNothingIsFound) {
  EXPECT_THAT(FoundIn({.heading = -1.0, .turn_rate = 0.02}), IsEmpty());
  EXPECT_THAT(FoundIn({.heading = -1.0}, 16.0), IsEmpty());
}

}  // namespace
}  // namespace limpet
