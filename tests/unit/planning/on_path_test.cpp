// SPDX-License-Identifier: MIT
#include "limpet/planning/on_path.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(OnPath, AVehicleIsOnAPathThatBeginsWhereItIsAndLooks) {
  const DubinsPath path({.north = 2.0, .east = -1.0, .yaw = 3.1}, {});
  EXPECT_TRUE(IsOnPath(path, {.north = 2.02, .east = -1.03, .yaw = 3.11}));
  EXPECT_TRUE(IsOnPath(path, {.north = 2.0, .east = -1.0, .yaw = 3.1 - 2.0 * std::numbers::pi}));
  EXPECT_FALSE(IsOnPath(path, {.north = 2.0, .east = -1.06, .yaw = 3.1}));
  EXPECT_FALSE(IsOnPath(path, {.north = 2.0, .east = -1.0, .yaw = 3.15}));
}

}  // namespace
}  // namespace limpet
