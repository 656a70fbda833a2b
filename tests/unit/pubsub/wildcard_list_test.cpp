// SPDX-License-Identifier: MIT
#include "limpet/pubsub/wildcard_list.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(WildcardListTest, OnePatternThatMatchesIsEnough) {
  EXPECT_TRUE(MatchesAny({"DB_*", "NAV_?"}, "NAV_X"));
  EXPECT_FALSE(MatchesAny({"DB_*", "NAV_?"}, "NAV_YAW"));
}

TEST(WildcardListTest, NoPatternMatchesNothingButChoosesAll) {
  EXPECT_FALSE(MatchesAny({}, "NAV_X"));
  EXPECT_TRUE(IsChosen({}, "NAV_X"));
  EXPECT_FALSE(IsChosen({"DB_*"}, "NAV_X"));
}

}  // namespace
}  // namespace limpet
