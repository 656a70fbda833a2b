// SPDX-License-Identifier: MIT
#include "limpet/simulation/rolling_shutter.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

const Pose kHover{.p_WB = {0.0, 0.0, 2.0}};
const Eigen::Vector3d kBelow(0.0, 0.0, 6.0);

TEST(RollingShutter, LeavesAPointAloneWithoutReadout) {
  EXPECT_EQ(SeenRowByRow({}, {}, kHover, {.v_B = {1.0, 0.0, 0.0}}, kBelow), kBelow);
}

TEST(RollingShutter, ShowsAPointWhereItIsAtItsRowsTime) {
  // The middle row is read after half of the readout, when the body has gone on by 0.05 m.
  const auto seen =
      SeenRowByRow({.readout = Seconds(0.1)}, {}, kHover,
                   {.v_B = {1.0, 0.0, 0.0}, .omega_B = Eigen::Vector3d::Zero()}, kBelow);
  EXPECT_NEAR(seen.x(), -0.05, 2e-3);
  EXPECT_NEAR(seen.z(), 6.0, 1e-12);
}

TEST(RollingShutter, TurnsWithTheBody) {
  const Eigen::Vector3d aside(0.0, 2.0, 6.0);
  const auto seen =
      SeenRowByRow({.readout = Seconds(0.1)}, {}, kHover,
                   {.v_B = Eigen::Vector3d::Zero(), .omega_B = {0.0, 0.0, 0.4}}, aside);
  EXPECT_NEAR(seen.x(), 2.0 * 0.4 * 0.05, 2e-3);  // seen turned back by half of it
}

}  // namespace
}  // namespace limpet
