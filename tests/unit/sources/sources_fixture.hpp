// SPDX-License-Identifier: MIT
// A source through the navigator: a vehicle whose dead reckoning drifts, with and without it.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "estimation/navigation/navigator.hpp"
#include "estimation/navigation/source_registry.hpp"
#include "limpet/core/random.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {

/// A source made of lines as a mission has them, e.g. {"sigma_m", "0.3"}.
inline std::unique_ptr<MeasurementSource> Made(
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
  static constexpr double kStep = 0.05;  // [s]
  static constexpr double kSpeed = 0.5;  // [m/s]

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
      navigator_->AddDepth(t_, Meters(p_W_.z()));
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

}  // namespace limpet
