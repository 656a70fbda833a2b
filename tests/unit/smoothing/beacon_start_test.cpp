// SPDX-License-Identifier: MIT
#include "tests/support/beacon_start.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

std::vector<RangeFrom> RangesTo(const Eigen::Vector2d& beacon,
                                const std::vector<Eigen::Vector2d>& places) {
  std::vector<RangeFrom> ranges;
  for (const Eigen::Vector2d& from : places)
    ranges.push_back({from, (beacon - from).norm()});
  return ranges;
}

TEST(StartOfBeacon, IsWhereTheRangesMeet) {
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i < 20; ++i)
    places.emplace_back(i, 0.05 * i * i);
  const auto start = StartOfBeacon(RangesTo({12.0, -9.0}, places), 0.5);
  ASSERT_TRUE(start);
  EXPECT_LT((*start - Eigen::Vector2d(12.0, -9.0)).norm(), 0.01);
}
TEST(StartOfBeacon, WaitsWhileTheMirroredPlaceFitsAsWell) {
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i < 40; ++i)
    places.emplace_back(i, 0.0);
  EXPECT_FALSE(StartOfBeacon(RangesTo({12.0, -9.0}, places), 0.5));
}
TEST(StartOfBeacon, WaitsWhileTheWayIsShort) {
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i < 40; ++i)
    places.emplace_back(0.01 * i, 0.01 * (i % 7));
  EXPECT_FALSE(StartOfBeacon(RangesTo({12.0, -9.0}, places), 0.5));
}

}  // namespace
}  // namespace limpet
