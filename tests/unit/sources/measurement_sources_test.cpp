// SPDX-License-Identifier: MIT
// Every source through the navigator: a vehicle whose dead reckoning drifts, with and without it.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "estimation/navigation/aiding_sources.hpp"
#include "estimation/navigation/navigator.hpp"
#include "estimation/navigation/source_registry.hpp"
#include "limpet/core/random.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {
namespace {

constexpr double kStep = 0.05;  // [s]
constexpr double kSpeed = 0.5;  // [m/s]

/// A source made of lines as a mission has them, e.g. {"sigma_m", "0.3"}.
std::unique_ptr<MeasurementSource> Made(
    const std::string& name, const std::vector<std::pair<std::string, std::string>>& lines) {
  auto factory = *FindSource(name);
  for (const auto& [key, value] : lines) {
    const std::vector<ParamSpec> specs = factory->Parameters();
    const auto spec = std::ranges::find(specs, key, &ParamSpec::name);
    EXPECT_TRUE(spec != specs.end() && !spec->set(value)) << key;
  }
  return factory->Make();
}

/// Legs of 60 s north and south, ten metres under water; the compass of the dead reckoning turns
/// by `yaw_drift_`, its velocity is off by `velocity_error_B_`.
class SourcesTest : public ::testing::Test {
 protected:
  void Hear(std::unique_ptr<MeasurementSource> source) {
    heard_.push_back(source.get());
    navigator_->AddSource(std::move(source));
  }
  void Say(int source, const Value& value) {
    auto seen = heard_[static_cast<std::size_t>(source)]->Observe(t_, value);
    ASSERT_NE(seen, nullptr);
    navigator_->AddObservation(source, seen);
  }
  /// `each_second`: what the source says then.
  template <class Each>
  void Go(double seconds, Each each_second) {
    for (const double end = t_ + seconds; t_ < end; t_ += kStep, ++steps_) {
      const double yaw = std::fmod(t_, 120.0) < 60.0 ? 0.0 : std::numbers::pi;
      p_W_ += kStep * kSpeed * Eigen::Vector3d(std::cos(yaw), 0.0, 0.0);
      yaw_ = yaw;
      navigator_->AddAttitude(
          {.t = t_, .roll = roll_, .yaw = yaw + yaw_drift_ * t_, .sd_yaw = 0.01});
      navigator_->AddDepth(t_, p_W_.z());
      if (steps_ == 0) navigator_->AddGps(t_, p_W_.head<2>(), 0.5);
      if (steps_ % 4 == 0)
        navigator_->AddVelocity(t_, Eigen::Vector3d(kSpeed, 0.0, 0.0) + velocity_error_B_);
      if (steps_ % 20 == 10) each_second();
      navigator_->Advance(t_);
    }
  }
  void SayFix(const Eigen::Vector3d& place_W) {
    const UsblFix fix{.north = place_W.x() + noise_.Normal(0.5),
                      .east = place_W.y() + noise_.Normal(0.5),
                      .down = place_W.z() + noise_.Normal(0.5),
                      .sd = 0.5};
    Say(0, TopicCodec<UsblFix>::Encode(fix));
  }
  /// No farther off than three sigmas, nor than `most` [m].
  void ExpectHonest(double most) const {
    const NavigatorEstimate estimate = navigator_->Estimate(t_);
    const double sigma = estimate.sd_p_W.head<2>().norm();
    EXPECT_LT(Error(), 3.0 * sigma);
    EXPECT_LT(Error(), most);
  }
  [[nodiscard]] double Error() const {
    return (navigator_->Estimate(t_).X_WB.p_WB - p_W_).head<2>().norm();
  }

  static NavigatorParams Params() {
    NavigatorParams params;
    params.odometry.yaw_walk = 1e-3;
    params.odometry.yaw_bias = 2e-4;
    return params;
  }

  std::unique_ptr<Navigator> navigator_ = std::make_unique<Navigator>(Params());
  std::vector<const MeasurementSource*> heard_;
  Random noise_{7, "sources"};
  Eigen::Vector3d p_W_{0.0, 0.0, 10.0}, velocity_error_B_ = Eigen::Vector3d::Zero();
  double t_ = 0.0, yaw_ = 0.0, yaw_drift_ = 0.0, roll_ = 0.0;
  int steps_ = 0;
};

TEST_F(SourcesTest, RangesToABeaconHoldAVehicleThatDriftsOff) {
  velocity_error_B_ = {0.0, 0.01, 0.0};
  const Eigen::Vector3d beacon(15.0, 40.0, 12.0), transducer(0.0, 0.0, -0.3);
  Hear(Made("beacon_range", {{"at_m", "15, 40, 12"}, {"transducer_m", "0 0 -0.3"}}));
  Go(900.0, [&] { Say(0, (p_W_ + transducer - beacon).norm() + noise_.Normal(0.3)); });
  EXPECT_LT(Error(), 1.0);
  EXPECT_GT(navigator_->aiding().counts(0).taken, 800);
}

TEST_F(SourcesTest, AnEchoSounderTellsTheAltitudeWhileTheDvlTellsNone) {
  Hear(Made("echo_sounder", {{"transducer_m", "0.3 0 0.2"}, {"greatest_m", "30"}}));
  Go(20.0, [] {});
  EXPECT_FALSE(navigator_->Estimate(t_).altitude);
  Go(20.0, [&] { Say(0, 6.0); });
  EXPECT_NEAR(navigator_->Estimate(t_).altitude.value(), 6.2, 1e-5);
  roll_ = 0.2;
  Go(20.0, [&] { Say(0, 6.0); });
  EXPECT_NEAR(navigator_->Estimate(t_).altitude.value(), 6.2 * std::cos(0.2), 1e-5);
  roll_ = 0.0;
  Go(20.0, [&] {
    navigator_->AddAltitude(t_, 5.0);
    Say(0, 6.0);
  });
  const double dvl = 5.0 + Params().odometry.dvl_B.z();
  EXPECT_NEAR(navigator_->Estimate(t_).altitude.value(), dvl, 1e-5);
  Go(20.0, [&] { Say(0, 100.0); });  // no echo
  EXPECT_FALSE(navigator_->Estimate(t_).altitude);
  EXPECT_EQ(navigator_->aiding().counts(0).taken, 60);
}

TEST_F(SourcesTest, AnEchoIsRefusedAndCounted) {
  const Eigen::Vector3d beacon(15.0, 40.0, 12.0);
  Hear(Made("beacon_range", {{"at_m", "15, 40, 12"}, {"greatest_m", "200"}}));
  int second = 0;
  Go(300.0, [&] {
    const double range = (p_W_ - beacon).norm();
    ++second;
    Say(0, second % 10 == 5 ? 3.0 * range : second % 10 == 0 ? 500.0 : range);
  });
  EXPECT_LT(Error(), 0.5);
  EXPECT_EQ(navigator_->aiding().counts(0).refused, 30);
  EXPECT_GE(navigator_->aiding().counts(0).unused, 29);  // further than any beacon; one waits
}

TEST_F(SourcesTest, AcousticFixesReplaceGpsUnderWater) {
  velocity_error_B_ = {0.02, 0.02, 0.0};
  Hear(Made("acoustic_fix", {{"sigma_m", "0.8"}, {"constant_sigma_m", "0.2"}}));
  Go(900.0, [&] { SayFix(p_W_); });
  ExpectHonest(1.0);
}

TEST_F(SourcesTest, ABeaconThatIsNotWhereItIsSaidToBeIsFoundAndMovesNobodyForSure) {
  const Eigen::Vector3d said(15.0, 40.0, 12.0), off(3.0, -3.0, 0.0);
  Hear(Made("beacon_range", {{"at_m", "15, 40, 12"}, {"at_sigma_m", "2"}}));
  Go(900.0, [&] { Say(0, (p_W_ - said - off).norm() + noise_.Normal(0.3)); });
  ExpectHonest(2.5);
  const auto errors = navigator_->aiding().ErrorsOf(0);
  ASSERT_TRUE(errors);
  for (const int axis : {0, 1}) {
    EXPECT_NEAR(errors->value(axis), off(axis), 3.0 * errors->sd(axis));
  }
}

TEST_F(SourcesTest, FixesThatAreAllOffByTheSameMoveNobodyForSure) {
  const Eigen::Vector3d off(-2.5, 2.0, 0.0);
  Hear(Made("acoustic_fix", {{"sigma_m", "0.8"}, {"constant_sigma_m", "2"}}));
  Go(900.0, [&] { SayFix(p_W_ + off); });
  ExpectHonest(1.0);
  const auto errors = navigator_->aiding().ErrorsOf(0);
  ASSERT_TRUE(errors);
  EXPECT_NEAR(errors->value.x(), off.x(), 3.0 * errors->sd.x());
  // One fix of 0.5 m, from a receiver that may be worse than it states.
  EXPECT_LT(errors->sd.x(), 1.2) << "where it dived the receiver knew";
}

TEST_F(SourcesTest, ACompassHoldsAHeadingThatDriftsAndItsDeviationIsFound) {
  yaw_drift_ = 2e-4;  // [rad/s]: ten degrees in a quarter of an hour
  constexpr double kDeviation = 0.03;
  Hear(Made("magnetic_heading", {{"sigma_deg", "1"}, {"deviation_deg", "2"}}));
  Go(900.0, [&] {
    ImuSample imu;
    imu.heading = WrapAngle(yaw_ + kDeviation * std::sin(yaw_ + 0.7) + noise_.Normal(0.01));
    Say(0, TopicCodec<ImuSample>::Encode(imu));
  });
  const double off = WrapAngle(navigator_->Estimate(t_).X_WB.yaw - yaw_);
  EXPECT_LT(std::abs(off), 3.0 * navigator_->Estimate(t_).sd_yaw);
  EXPECT_LT(std::abs(off), 0.05);
  const auto errors = navigator_->aiding().ErrorsOf(0);
  ASSERT_TRUE(errors);
  EXPECT_LT(errors->sd.z(), 0.9 * Radians::FromTextUnit(2.0).value());  // legs tell it apart
}

TEST_F(SourcesTest, ASourceOfNoUseChangesNothing) {
  Hear(Made("magnetic_heading", {{"period_s", "600"}}));
  Go(30.0, [&] { Say(0, TopicCodec<ImuSample>::Encode(ImuSample{})); });
  const int with = navigator_->node_count();
  const SourceCounts counts = navigator_->aiding().counts(0);
  EXPECT_EQ(counts.taken, 1);
  navigator_ = std::make_unique<Navigator>(Params());
  heard_.clear();
  t_ = 0.0, steps_ = 0;
  Go(30.0, [] {});
  EXPECT_LE(with, navigator_->node_count() + 1);
}

TEST(MeasurementSources, NonsenseIsNoObservation) {
  const auto beacon = Made("beacon_range", {});
  EXPECT_EQ(beacon->Observe(0.0, Value(-1.0)), nullptr);
  EXPECT_EQ(beacon->Observe(0.0, Value(std::nan(""))), nullptr);
  EXPECT_EQ(beacon->Observe(0.0, Value(std::string("near"))), nullptr);
  EXPECT_EQ(Made("acoustic_fix", {})->Observe(0.0, Value(std::string("north=x"))), nullptr);
}

TEST(MeasurementSources, AnUnknownNameNamesTheNearest) {
  const auto found = FindSource("beacon_rage");
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().text,
            "no measurement source `beacon_rage`; did you mean `beacon_range`?");
}

}  // namespace
}  // namespace limpet
