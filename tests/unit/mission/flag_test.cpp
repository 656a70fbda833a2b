// SPDX-License-Identifier: MIT
#include "limpet/mission/flag.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

std::optional<std::string> Macro(std::string_view name) {
  if (name == "OSX") return "12.5";
  if (name == "BHVNAME") return "cover";
  return std::nullopt;
}

Value Resolved(const std::string& text) {
  const Expected<Flag> flag = Flag::Parse(text);
  EXPECT_TRUE(flag.has_value()) << text;
  return flag->Resolve(Macro);
}

TEST(Flag, PostsNumericTextAsADouble) { EXPECT_EQ(Resolved("SPEED = 2.5"), Value(2.5)); }

TEST(Flag, PostsQuotedNumbersAsStrings) {
  EXPECT_EQ(Resolved("A = \"2.5\""), Value(std::string("2.5")));
}

TEST(Flag, KeepsEqualSignsInTheValue) {
  EXPECT_EQ(Resolved("UP = speed=2 # points=0,0"), Value(std::string("speed=2 # points=0,0")));
}

TEST(Flag, PostsALoneNumericMacroAsADouble) { EXPECT_EQ(Resolved("A = $[OSX]"), Value(12.5)); }

TEST(Flag, PostsMacrosInsideTextAsAString) {
  EXPECT_EQ(Resolved("A = 3$[OSX]"), Value(std::string("312.5")));
  EXPECT_EQ(Resolved("A = x=$[OSX],by=$[BHVNAME]"), Value(std::string("x=12.5,by=cover")));
}

TEST(Flag, LeavesUnknownMacrosAlone) {
  EXPECT_EQ(Resolved("A = $[NONE]!"), Value(std::string("$[NONE]!")));
}

TEST(Flag, TakesParenthesisMacrosOnlyWhereAsked) {
  Flag flag = *Flag::Parse("A = $(OSX)");
  EXPECT_EQ(flag.Resolve(Macro), Value(std::string("$(OSX)")));
  flag.has_parenthesis_macros = true;
  EXPECT_EQ(flag.Resolve(Macro), Value(12.5));
}

TEST(Flag, CarriesItsCondition) {
  const Flag flag = *Flag::Parse("RETURN = true [if] MODE == ACTIVE");
  ASSERT_TRUE(flag.condition.has_value());
  EXPECT_EQ(flag.condition->text(), "MODE == ACTIVE");
  EXPECT_EQ(flag.text, "true");
}

TEST(Flag, ReadsTagAndGroup) {
  const Flag flag = *Flag::Parse("@cpa #all+ REPORT = done");
  EXPECT_EQ(flag.tag, "cpa");
  EXPECT_EQ(flag.group, "all");
  EXPECT_TRUE(flag.is_also_local);
  EXPECT_FALSE(Flag::Parse("#red A = 1")->is_also_local);
  EXPECT_EQ(Flag::Parse("<50 A = 1")->tag, "<50");
}

TEST(Flag, RefusesWhatIsNoPost) {
  EXPECT_FALSE(Flag::Parse("").has_value());
  EXPECT_FALSE(Flag::Parse("A").has_value());
  EXPECT_FALSE(Flag::Parse("A = ").has_value());
  EXPECT_FALSE(Flag::Parse("A B = 1").has_value());
  EXPECT_FALSE(Flag::Parse("A = 1 [if] B").has_value());
}

}  // namespace
}  // namespace limpet
