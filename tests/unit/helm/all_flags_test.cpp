// SPDX-License-Identifier: MIT
#include "limpet/helm/all_flags.hpp"

#include <set>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(AllFlags, LeaveNoListOut) {
  const FlagLists lists{};
  const auto all = AllFlags(lists);
  EXPECT_EQ(std::set(all.begin(), all.end()).size(), sizeof(FlagLists) / sizeof(lists.run));
}

}  // namespace
}  // namespace limpet
