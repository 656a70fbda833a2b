// SPDX-License-Identifier: MIT
#include "limpet/sensors/sonar_model.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

constexpr double kSonarSeabed = 8.0;

SonarSheet QuietFan() {
  SonarSheet sheet;
  sheet.is_present = true;
  sheet.p_BS.setZero();
  sheet.range_noise_m = 0.0;
  sheet.beams = 31;
  sheet.fan = Radians::FromTextUnit(120.0);
  return sheet;
}

SonarPing PingOf(const SonarSheet& sheet, std::vector<UprightBody> bodies, const SimTruth& truth) {
  SonarModel sonar(sheet,
                   {[](const Eigen::Vector2d&) { return kSonarSeabed; }, {}, std::move(bodies)},
                   Random(3));
  return *sonar.Sample(truth, Seconds(0.0));
}

TEST(SonarModel, SaysHowFarAColumnAheadIs) {
  SimTruth truth;
  truth.down = 4.0, truth.yaw = RadiansFromDegrees(90.0);
  const SonarPing ping =
      PingOf(QuietFan(), {UprightBody::Column({0.0, 9.0}, {.radius = 0.5, .top = 0.0})}, truth);
  ASSERT_EQ(ping.ranges.size(), 31U);
  EXPECT_NEAR(ping.ranges[15], 8.5, 1e-3);
  EXPECT_EQ(ping.ranges[14], 0.0);  // 4 deg aside: 0.63 m beside its axis
  EXPECT_EQ(ping.ranges[0], 0.0);
}

TEST(SonarModel, HearsOnTheBearingThatItNames) {
  SimTruth truth;
  truth.down = 4.0;
  const SonarPing ping =
      PingOf(QuietFan(), {UprightBody::Column({0.0, 6.0}, {.radius = 3.0, .top = 0.0})}, truth);
  double nearest_bearing = -9.0;
  for (std::size_t i = 0; i < ping.ranges.size(); ++i) {
    if (ping.ranges[i] > 0.0) {
      nearest_bearing = ping.first + static_cast<double>(i) * ping.step;
      break;
    }
  }
  EXPECT_NEAR(nearest_bearing, RadiansFromDegrees(60.0), RadiansFromDegrees(1.0));
}

TEST(SonarModel, HearsNothingBeyondItsReachAndNothingOfWhatIsLower) {
  SimTruth truth;
  truth.down = 4.0;
  const auto is_silent = [](double range) { return range == 0.0; };
  EXPECT_TRUE(std::ranges::all_of(
      PingOf(QuietFan(), {UprightBody::Column({16.0, 0.0}, {.radius = 0.5, .top = 0.0})}, truth)
          .ranges,
      is_silent));
  EXPECT_TRUE(std::ranges::all_of(
      PingOf(QuietFan(), {UprightBody::Column({9.0, 0.0}, {.radius = 0.5, .top = 5.0})}, truth)
          .ranges,
      is_silent));
}

TEST(SonarModel, ALevelFanHearsASeabedThatRisesAhead) {
  SimTruth truth;
  truth.down = 6.0;
  SonarModel sonar(
      QuietFan(), {[](const Eigen::Vector2d& p_W) { return 8.0 - 0.25 * p_W.x(); }, {}}, Random(3));
  EXPECT_NEAR(sonar.Sample(truth, Seconds(0.0))->ranges[15], 8.0, 0.02);
}

TEST(SonarModel, ANoseThatPointsDownHearsTheSeabed) {
  SimTruth truth;
  truth.down = 4.0, truth.pitch = RadiansFromDegrees(-40.0);
  const SonarPing ping = PingOf(QuietFan(), {}, truth);
  EXPECT_NEAR(ping.ranges[15], 4.0 / std::sin(RadiansFromDegrees(40.0)), 0.02);
}

}  // namespace
}  // namespace limpet
