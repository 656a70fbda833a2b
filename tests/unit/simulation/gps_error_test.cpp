// SPDX-License-Identifier: MIT
#include "limpet/simulation/gps_error.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(GpsError, IsNothingUnlessToldOtherwise) {
  GpsError error({}, Random(1));
  EXPECT_EQ(error.At(Seconds(3.0)), Eigen::Vector2d(0.0, 0.0));
}

TEST(GpsError, JumpsForAWhileToOnePlace) {
  GpsError error({.jumps_per_h = 60.0,
                  .jump = Meters(20.0),
                  .shortest_jump = Seconds(5.0),
                  .longest_jump = Seconds(5.0)},
                 Random(1));
  int away = 0, moves = 0;
  Eigen::Vector2d last = Eigen::Vector2d::Zero();
  for (int i = 0; i < 36000; ++i) {
    const Eigen::Vector2d off = error.At(Seconds(0.1 * i));
    away += off.isZero(0.0) ? 0 : 1;
    moves += off != last && !off.isZero(0.0) ? 1 : 0;
    last = off;
  }
  EXPECT_NEAR(moves, 55, 20);
  EXPECT_NEAR(away, 50 * moves, 50);
}

TEST(GpsError, WandersByItsSigma) {
  GpsError error({.walk = Meters(2.0), .walk_time = Seconds(1.0)}, Random(1));
  double squares = 0.0;
  for (int i = 0; i < 2000; ++i)
    squares += error.At(Seconds(3.0 * i)).squaredNorm() / 2.0;
  EXPECT_NEAR(std::sqrt(squares / 2000.0), 2.0, 0.15);
}

}  // namespace
}  // namespace limpet
