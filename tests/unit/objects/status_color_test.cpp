// SPDX-License-Identifier: MIT
#include "limpet/objects/status_color.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

constexpr Status kDecided[] = {Status::kConfirmed, Status::kRemoved, Status::kNew, Status::kMoved};

TEST(StatusColor, IsTheSameColourInSvgAndInVoxels) {
  for (const Status status : kDecided) {
    const StatusColor color = ColorOf(status).value();
    EXPECT_EQ(color.hex, fmt::format("#{:02x}{:02x}{:02x}", color.red, color.green, color.blue));
  }
}

TEST(StatusColor, TellsEveryDecisionFromEveryOther) {
  std::vector<std::string_view> hex, moos;
  for (const Status status : kDecided) {
    hex.push_back(ColorOf(status)->hex);
    moos.push_back(ColorOf(status)->moos);
  }
  for (std::vector<std::string_view>* colors : {&hex, &moos}) {
    std::ranges::sort(*colors);
    EXPECT_EQ(std::ranges::adjacent_find(*colors), colors->end());
  }
}

TEST(StatusColor, IsNoneOfWhatIsNotDecided) {
  for (const Status status : {Status::kUncertain, Status::kNotInspected, Status::kNothing})
    EXPECT_FALSE(ColorOf(status));
}

}  // namespace
}  // namespace limpet
