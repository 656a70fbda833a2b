// SPDX-License-Identifier: MIT
#include "limpet/topics/grid_place.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace limpet {
namespace {

constexpr GridFrame kSmallGrid{
    .north_min = -10.0, .east_min = 4.0, .cell_m = 0.5, .rows = 3, .columns = 2};

TEST(GridPlaceOf, IsTheCellAboveItsSouthWestCorner) {
  const auto corner = GridPlaceOf(kSmallGrid, {-10.0, 4.0});
  ASSERT_TRUE(corner);
  EXPECT_EQ(corner->row, 0);
  EXPECT_EQ(corner->column, 0);
  const auto last = GridPlaceOf(kSmallGrid, {-8.6, 4.9});
  ASSERT_TRUE(last);
  EXPECT_EQ(last->row, 2);
  EXPECT_EQ(last->column, 1);
}

TEST(GridPlaceOf, IsNothingOutside) {
  EXPECT_FALSE(GridPlaceOf(kSmallGrid, {-10.01, 4.1}));
  EXPECT_FALSE(GridPlaceOf(kSmallGrid, {-9.9, 3.99}));
  EXPECT_FALSE(GridPlaceOf(kSmallGrid, {-8.5, 4.1})) << "the northern edge is the next grid's";
  EXPECT_FALSE(GridPlaceOf(kSmallGrid, {-9.9, 5.0}));
}

TEST(GridPlaceOf, IsNothingForNoPlaceOrNoGrid) {
  EXPECT_FALSE(GridPlaceOf(kSmallGrid, {std::numeric_limits<double>::quiet_NaN(), 4.1}));
  EXPECT_FALSE(GridPlaceOf(kSmallGrid, {-9.9, std::numeric_limits<double>::infinity()}));
  EXPECT_FALSE(GridPlaceOf(GridFrame{}, {0.0, 0.0}));
}

}  // namespace
}  // namespace limpet
