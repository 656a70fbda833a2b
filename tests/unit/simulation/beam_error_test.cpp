// SPDX-License-Identifier: MIT
#include "limpet/simulation/beam_error.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

const Eigen::Vector3d kVelocity(0.5, -0.1, 0.05);
constexpr double kAngle = 0.4363;

TEST(BeamError, ThreeBeamsAreEnough) {
  BeamError error({.loss_share = 0.5}, kAngle, Random(1));
  const auto said = error.Velocity(kVelocity, {}, {false, true, false, false});
  ASSERT_TRUE(said);
  EXPECT_NEAR((*said - kVelocity).norm(), 0.0, 1e-9);
  EXPECT_FALSE(error.Velocity(kVelocity, {}, {false, true, false, true}));
}

TEST(BeamError, LosesItsShareOfBeams) {
  BeamError error({.loss_share = 0.25}, kAngle, Random(1));
  int lost = 0;
  for (int i = 0; i < 4000; ++i) {
    for (const bool is_lost : error.DrawLost())
      lost += is_lost ? 1 : 0;
  }
  EXPECT_NEAR(lost / 16000.0, 0.25, 0.015);
}

TEST(BeamError, ASlopeAheadFakesSpeed) {
  BeamError error({.slope_bias = 0.1}, kAngle, Random(1));
  // Falls by 0.2 along the fore beams and rises as much along the aft ones.
  const auto said = error.Velocity({0.5, 0.0, 0.0}, {0.2, -0.2, -0.2, 0.2}, {});
  ASSERT_TRUE(said);
  EXPECT_NEAR(said->x(), 0.5, 1e-9);
  EXPECT_NEAR(said->z(), 0.5 * 0.1 * 0.2 * std::tan(kAngle) * std::sqrt(0.5), 1e-9);
}

TEST(BeamError, IsNothingUnlessToldOtherwise) {
  BeamError error({}, kAngle, Random(1));
  EXPECT_EQ(*error.Velocity(kVelocity, {0.3, 0.1, 0.0, 0.0}, error.DrawLost()), kVelocity);
}

}  // namespace
}  // namespace limpet
