// SPDX-License-Identifier: MIT
#include "limpet/simulation/false_velocity.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(FalseVelocity, SaysOneWrongVelocityPerBurst) {
  FalseVelocity bursts({.per_h = 120.0,
                        .shortest = Seconds(3.0),
                        .longest = Seconds(3.0),
                        .least = MetersPerSecond(0.5),
                        .most = MetersPerSecond(0.6)},
                       Random(1));
  int count = 0, changes = 0;
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  for (int i = 0; i < 18000; ++i) {
    const Eigen::Vector3d off = bursts.At(Seconds(0.2 * i));
    if (!off.isZero(0.0)) {
      EXPECT_GE(off.head<2>().norm(), 0.5);
      EXPECT_LE(off.head<2>().norm(), 0.6);
      ++count;
      changes += off != last ? 1 : 0;
    }
    last = off;
  }
  EXPECT_NEAR(changes, 109, 30);
  EXPECT_NEAR(count, 15 * changes, changes);
}

}  // namespace
}  // namespace limpet
