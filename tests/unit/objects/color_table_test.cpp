// SPDX-License-Identifier: MIT
#include "limpet/objects/color_table.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(ColorTable, HasAPaintForEachOfItsNames) {
  for (const std::string& name : ColorNames()) {
    const std::optional<Albedo> paint = AlbedoOf(name);
    ASSERT_TRUE(paint) << name;
    EXPECT_TRUE(std::ranges::all_of(*paint, [](float share) { return share > 0 && share < 1; }))
        << name;
  }
}

TEST(ColorTable, HasEachNameOnce) {
  std::vector<std::string> names = ColorNames();
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

TEST(ColorTable, HasNoPaintForAnyOtherWord) {
  EXPECT_FALSE(AlbedoOf("none"));
  EXPECT_FALSE(AlbedoOf("Yellow"));
  EXPECT_FALSE(AlbedoOf(""));
}

}  // namespace
}  // namespace limpet
