// SPDX-License-Identifier: MIT
#include "limpet/core/expected.hpp"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(Expected, LetsItsValueBeChangedInPlace) {
  Expected<std::vector<int>> numbers{std::vector<int>{1}};
  (*numbers).push_back(2);
  numbers->push_back(3);
  EXPECT_EQ(*numbers, (std::vector<int>{1, 2, 3}));
}

TEST(Expected, GivesItsValueAway) {
  Expected<std::unique_ptr<int>> number{std::make_unique<int>(7)};
  const std::unique_ptr<int> taken = *std::move(number);
  EXPECT_EQ(*taken, 7);
}

TEST(Expected, SaysWhyThereIsNoValue) {
  const Expected<int> nothing{Error{"no such file"}};
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().text, "no such file");
}

}  // namespace
}  // namespace limpet
