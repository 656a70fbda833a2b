// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/pubsub/wildcard.hpp"
#include "limpet/pubsub/wildcard_text.hpp"

namespace limpet {
namespace {

/// By definition: `*` is nothing, or one character and then `*`.
bool MatchesByDefinition(std::string_view pattern, std::string_view text) {
  if (pattern.empty()) return text.empty();
  if (pattern.front() == '*') {
    return MatchesByDefinition(pattern.substr(1), text) ||
           (!text.empty() && MatchesByDefinition(pattern, text.substr(1)));
  }
  return !text.empty() && (pattern.front() == '?' || pattern.front() == text.front()) &&
         MatchesByDefinition(pattern.substr(1), text.substr(1));
}

std::string DrawText(Random& random, std::string_view letters, std::uint64_t longest) {
  std::string text;
  for (std::uint64_t i = random.Index(longest + 1); i > 0; --i)
    text += letters[random.Index(letters.size())];
  return text;
}

TEST(WildcardProperties, MatchesWhatItsDefinitionSays) {
  Random random(91);
  int matches = 0;
  for (int i = 0; i < 5000; ++i) {
    const std::string pattern = DrawText(random, "AB*?", 7), text = DrawText(random, "ABB", 8);
    const bool expected = MatchesByDefinition(pattern, text);
    EXPECT_EQ(MatchesWildcard(pattern, text), expected) << pattern << " of " << text;
    matches += expected ? 1 : 0;
  }
  EXPECT_GT(matches, 300);
}

TEST(WildcardProperties, EveryTextMatchesItselfAndAnythingMatchesAStar) {
  Random random(92);
  for (int i = 0; i < 300; ++i) {
    const std::string text = DrawText(random, "ABC_1", 12);
    EXPECT_TRUE(MatchesWildcard(text, text));
    EXPECT_TRUE(MatchesWildcard("*", text));
    EXPECT_TRUE(MatchesWildcard(std::string(text.size(), '?'), text));
    EXPECT_FALSE(MatchesWildcard(std::string(text.size() + 1, '?'), text));
  }
}

TEST(WildcardProperties, AStarMoreNeverMatchesLess) {
  Random random(93);
  for (int i = 0; i < 2000; ++i) {
    std::string pattern = DrawText(random, "AB*?", 6);
    const std::string text = DrawText(random, "AB", 7);
    if (!MatchesWildcard(pattern, text)) continue;
    pattern.insert(random.Index(pattern.size() + 1), "*");
    EXPECT_TRUE(MatchesWildcard(pattern, text)) << pattern << " of " << text;
  }
}

TEST(WildcardProperties, APatternMadeToTakeLongIsAnsweredAtOnce) {
  std::string pattern;
  for (int i = 0; i < 200; ++i)
    pattern += "*A";
  EXPECT_FALSE(MatchesWildcard(pattern + "B", std::string(5000, 'A')));
  EXPECT_TRUE(MatchesWildcard(pattern, std::string(5000, 'A')));
}

TEST(WildcardText, BringsBackEveryFilter) {
  Random random(94);
  for (int i = 0; i < 300; ++i) {
    const WildcardFilter sent{.app_pattern = DrawText(random, "pA*?", 6) + "x",
                              .variable_pattern = DrawText(random, "NAV_*?", 8) + "y",
                              .interval = Seconds(std::exp(random.Uniform(-20.0, 20.0)))};
    const auto back = ParseWildcard(TextOf(sent));
    ASSERT_TRUE(back) << TextOf(sent);
    EXPECT_EQ(back->app_pattern, sent.app_pattern);
    EXPECT_EQ(back->variable_pattern, sent.variable_pattern);
    EXPECT_EQ(back->interval, sent.interval);
  }
}

TEST(WildcardText, IsReadInAnyOrderWithBlanksAndPartsThatAreNotKnown) {
  for (const char* text : {"Interval=0.5,VarPattern=NAV_*,AppPattern=p*",
                           " AppPattern = p* ,\tVarPattern= NAV_* ,"
                           "Interval = 0.5 ",
                           "AppPattern=p*,Later=thing,VarPattern=NAV_*,Interval=0.5"}) {
    const auto filter = ParseWildcard(text);
    ASSERT_TRUE(filter) << text;
    EXPECT_EQ(filter->app_pattern, "p*") << text;
    EXPECT_EQ(filter->variable_pattern, "NAV_*") << text;
    EXPECT_EQ(filter->interval, Seconds(0.5)) << text;
  }
}

TEST(WildcardText, WhatItLeavesOutMatchesAll) {
  EXPECT_EQ(ParseWildcard("AppPattern=p*")->variable_pattern, "*");
  EXPECT_EQ(ParseWildcard("VarPattern=X")->app_pattern, "*");
  EXPECT_EQ(ParseWildcard("VarPattern=X")->interval, Seconds(0.0));
}

TEST(WildcardText, OtherTextIsNone) {
  for (const char* text : {"", "X", "Interval=1", "AppPattern=p*,X", "AppPattern=p*,Interval=soon",
                           "AppPattern=p*,Interval=", "apppattern=p*"})
    EXPECT_FALSE(ParseWildcard(text)) << text;
}

}  // namespace
}  // namespace limpet
