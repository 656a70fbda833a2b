// SPDX-License-Identifier: MIT
#include "limpet/waypoints/left_of.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(LeftOf, IsTwiceTheTrianglesAreaPositiveToTheLeft) {
  const MapPoint from{.x = 1.0, .y = 1.0}, to{.x = 1.0, .y = 5.0};  // north
  EXPECT_EQ(LeftOf(from, to, {.x = -2.0, .y = 2.0}), 12.0) << "west of it";
  EXPECT_EQ(LeftOf(from, to, {.x = 4.0, .y = 2.0}), -12.0);
  EXPECT_EQ(LeftOf(from, to, {.x = 1.0, .y = 9.0}), 0.0) << "straight ahead";
}

}  // namespace
}  // namespace limpet
