// SPDX-License-Identifier: MIT
#include "estimation/navigation/depth_errors.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "estimation/navigation/navigator.hpp"

namespace limpet {
namespace {

constexpr double kFloats = 0.13;  // [m] deep at the surface

/// A vehicle whose pressure sensor reads too deep floats, with fixes, and then dives.
class DepthErrorsTest : public ::testing::Test {
 protected:
  void Go(double down, double sink_mps, double seconds, bool has_fixes) {
    for (const double end = t_ + seconds; t_ < end; t_ += 0.1, down += 0.1 * sink_mps) {
      navigator_.AddAttitude({.t = t_});
      navigator_.AddVelocity(t_, Eigen::Vector3d(0.0, 0.0, sink_mps));
      navigator_.AddDepth(t_, Meters(down + bias_));
      if (has_fixes && ++steps_ % 10 == 0) navigator_.AddGps(t_, {0.0, 0.0}, 0.4);
      navigator_.Advance(t_);
    }
    navigator_.Advance(t_ + 1.0);
  }
  [[nodiscard]] NamedState State(const std::string& name) const {
    const std::vector<NamedState> states = navigator_.States(t_);
    const auto found = std::ranges::find(states, name, &NamedState::name);
    return found == states.end() ? NamedState{} : *found;
  }
  double bias_ = 0.4, t_ = 0.0;
  int steps_ = 0;
  Navigator navigator_{NavigatorParams{}};
};

TEST_F(DepthErrorsTest, TheBiasIsTakenFromReadingsAtTheSurface) {
  Go(kFloats, 0.0, 40.0, true);
  Go(kFloats, 0.2, 20.0, false);
  Go(kFloats + 4.0, 0.0, 20.0, false);
  const NamedState bias = State("depth_bias");
  EXPECT_NEAR(bias.value, bias_, 2.5 * bias.sd);
  EXPECT_LT(bias.sd, 0.1);
  const NavigatorEstimate estimate = navigator_.Estimate(t_);
  EXPECT_NEAR(estimate.X_WB.p_WB.z(), kFloats + 4.0, 2.5 * estimate.sd_p_W.z());
  EXPECT_NEAR(estimate.sd_p_W.z(), bias.sd, 0.03) << "an absolute depth is as good as its zero";
}

TEST_F(DepthErrorsTest, WithoutASurfaceTheBiasStaysAsUnknownAsItWas) {
  Go(6.0, 0.0, 40.0, true);
  const NamedState bias = State("depth_bias");
  EXPECT_NEAR(bias.value, 0.0, 0.01) << "fixes under water say nothing of the surface";
  EXPECT_NEAR(bias.sd, NavigatorParams{}.depth_bias_sigma.value(), 0.01);
}

TEST_F(DepthErrorsTest, TheBiasMayChangeInALongDive) {
  Go(kFloats, 0.0, 40.0, true);
  const double at_surface = State("depth_bias").sd;
  Go(kFloats, 0.2, 20.0, false);
  Go(kFloats + 4.0, 0.0, 3600.0, false);
  EXPECT_GT(State("depth_bias").sd, at_surface + 0.005);
}

}  // namespace
}  // namespace limpet
