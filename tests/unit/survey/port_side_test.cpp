// SPDX-License-Identifier: MIT
#include "limpet/survey/port_side.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(CrossToPort, IsPositiveToPort) {
  const Eigen::Vector2d north(2.0, 0.0), east(0.0, 3.0);
  EXPECT_EQ(CrossToPort(east, north), 6.0) << "who goes east has north to port";
  EXPECT_EQ(CrossToPort(north, east), -6.0);
  EXPECT_EQ(CrossToPort(north, -north), 0.0);
}

}  // namespace
}  // namespace limpet
