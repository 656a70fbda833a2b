// SPDX-License-Identifier: MIT
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "estimation/navigation/aiding_sources.hpp"
#include "limpet/topics/sensors.hpp"
#include "tests/unit/sources/sources_fixture.hpp"

namespace limpet {
namespace {

using MagneticHeadingTest = SourcesTest;

TEST_F(MagneticHeadingTest, ACompassHoldsAHeadingThatDriftsAndItsDeviationIsFound) {
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

TEST_F(MagneticHeadingTest, ASourceOfNoUseChangesNothing) {
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

}  // namespace
}  // namespace limpet
