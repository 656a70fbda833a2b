// SPDX-License-Identifier: MIT
#include "limpet/mission/condition.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Table = std::map<std::string, Value, std::less<>>;

ValueLookup LookupIn(const Table& table) {
  return [&table](std::string_view name) -> const Value* {
    const auto found = table.find(name);
    return found == table.end() ? nullptr : &found->second;
  };
}

/// Whether `text` holds over `table`; a text that does not parse fails the test.
bool Holds(const std::string& text, const Table& table, double utc = 0.0) {
  Expected<Condition> condition = Condition::Parse(text);
  EXPECT_TRUE(condition.has_value()) << text;
  Condition copy = *condition;
  return copy.Holds(LookupIn(table), Seconds(utc));
}

bool Parses(const std::string& text) { return Condition::Parse(text).has_value(); }

TEST(Condition, ComparesStringsExactlyAndWithCase) {
  const Table table{{"DEPLOY", std::string("true")}};
  EXPECT_TRUE(Holds("DEPLOY = true", table));
  EXPECT_TRUE(Holds("DEPLOY=\"true\"", table));
  EXPECT_FALSE(Holds("DEPLOY = True", table));
  EXPECT_TRUE(Holds("DEPLOY != false", table));
}

TEST(Condition, MatchesFieldsWithDoubleEquals) {
  const Table table{{"MODE", std::string("ACTIVE:SURVEYING:LEG1")}};
  EXPECT_TRUE(Holds("MODE == ACTIVE", table));
  EXPECT_TRUE(Holds("MODE == SURVEYING:LEG1", table));
  EXPECT_TRUE(Holds("MODE == ACTIVE:SURVEYING:LEG1:MORE", table));
  EXPECT_FALSE(Holds("MODE == ACTIVE:LEG1", table));
  EXPECT_FALSE(Holds("MODE == ACT", table));
  EXPECT_FALSE(Holds("MODE = ACTIVE", table));
}

TEST(Condition, ComparesNumbers) {
  const Table table{{"NAV_DEPTH", 5.0}};
  EXPECT_TRUE(Holds("NAV_DEPTH > 4.9", table));
  EXPECT_TRUE(Holds("NAV_DEPTH <= 5", table));
  EXPECT_TRUE(Holds("NAV_DEPTH == 5", table));
  EXPECT_FALSE(Holds("NAV_DEPTH < -5", table));
}

TEST(Condition, ReadsAStringAsANumberIfItLooksLikeOne) {
  const Table table{{"A", std::string("3")}, {"B", std::string("three")}, {"C", 3.0}};
  EXPECT_TRUE(Holds("A = 3", table));
  EXPECT_TRUE(Holds("C = \"3\"", table));
  EXPECT_FALSE(Holds("B = 3", table));
  EXPECT_FALSE(Holds("B != 3", table));
}

TEST(Condition, OrdersStringsLexically) {
  EXPECT_TRUE(Holds("A < bravo", {{"A", std::string("alpha")}}));
}

TEST(Condition, ComparesWithAnotherVariable) {
  const Table table{{"A", 3.0}, {"LIMIT", 4.0}};
  EXPECT_TRUE(Holds("A < $(LIMIT)", table));
  EXPECT_FALSE(Holds("A < $(UNKNOWN)", table));
}

TEST(Condition, IsFalseForAnUnknownVariableAlsoWhenUnequal) {
  EXPECT_FALSE(Holds("A != 1", {}));
  EXPECT_TRUE(Holds("!(A != 1)", {}));
}

TEST(Condition, CombinesParenthesisedSides) {
  const Table table{{"A", 1.0}, {"B", 2.0}, {"C", 0.0}};
  EXPECT_TRUE(Holds("((A=1) and (B=3)) or (C=0)", table));
  EXPECT_FALSE(Holds("(A=1) AND ((B=3) Or (C=1))", table));
  EXPECT_TRUE(Holds("(A=1) and !(B=3)", table));
  EXPECT_TRUE(Holds("(A=1)and(B=2)", table));
}

TEST(Condition, RefusesSidesWithoutParentheses) {
  EXPECT_FALSE(Parses("A=1 and B=2"));
  EXPECT_FALSE(Parses("(A=1) and (B=2) and (C=3)"));
  EXPECT_THAT(Condition::Parse("(A=1) or B=2").error().text, HasSubstr("each side of `or`"));
}

TEST(Condition, RefusesBrokenText) {
  for (const char* text : {"", "  ", "A", "= 3", "A =", "(A=1", "A=1)", "A = b=c", "or = 3",
                           "(A=1) and ()", "!A=1", "A = or", ")("}) {
    EXPECT_FALSE(Parses(text)) << text;
  }
}

TEST(Condition, TakesLiteralsWithBlanksAndColons) {
  EXPECT_TRUE(Holds("A = two words", {{"A", std::string("two words")}}));
  EXPECT_TRUE(Holds("A = \"or\"", {{"A", std::string("or")}}));
}

TEST(Condition, KeepsTheFirstTypeOfAVariable) {
  Condition condition = *Condition::Parse("A = on");
  Table table{{"A", std::string("on")}};
  EXPECT_TRUE(condition.Holds(LookupIn(table), Seconds(0.0)));
  table["A"] = 1.0;
  EXPECT_TRUE(condition.Holds(LookupIn(table), Seconds(0.0)));
  table["A"] = std::string("off");
  EXPECT_FALSE(condition.Holds(LookupIn(table), Seconds(0.0)));
}

TEST(Condition, ReadsADeltaAsSecondsSinceAStamp) {
  EXPECT_TRUE(Holds("FIX_DELTA > 9", {{"FIX", 100.0}}, 110.0));
  EXPECT_FALSE(Holds("FIX_DELTA > 9", {{"FIX", 100.0}, {"FIX_DELTA", 1.0}}, 110.0));
}

TEST(Condition, ListsItsVariables) {
  const Condition condition = *Condition::Parse("(B < $(C)) or !(A = 1)");
  EXPECT_THAT(condition.Variables(), ElementsAre("A", "B", "C"));
}

TEST(Condition, OfABehaviorFileMayWriteACommaForEquals) {
  EXPECT_EQ(Condition::ParseWithCommas("(DEPLOY, true) and (A < 3)")->Variables(),
            (std::vector<std::string>{"A", "DEPLOY"}));
  Condition list = *Condition::ParseWithCommas("S = a,b");
  EXPECT_TRUE(list.Holds(LookupIn({{"S", std::string("a,b")}}), Seconds(0.0)))
      << "where something else compares, a comma is part of the value";
  EXPECT_FALSE(Condition::ParseWithCommas("a,b,c").has_value());
}

TEST(Condition, RefusesHostileNesting) {
  std::string text = "A=1";
  for (int i = 0; i < 5000; ++i) {
    text = "!(" + text + ")";
  }
  EXPECT_FALSE(Parses(text));
}

TEST(Condition, ThousandsOfParenthesesAreRefusedAtOnce) {
  const std::string open(2000, '('), close(2000, ')');
  EXPECT_THAT(Condition::Parse(open + "A = 1" + close).error().text,
              HasSubstr("nested too deeply"));
  EXPECT_THAT(Condition::Parse("A = " + std::string(5000, 'x')).error().text,
              HasSubstr("longer than 4096 bytes"));
}

}  // namespace
}  // namespace limpet
