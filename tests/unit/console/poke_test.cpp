// SPDX-License-Identifier: MIT
#include "limpet/console/poke.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::HasSubstr;

Poke Parsed(std::string_view word) {
  Expected<Poke> poke = ParsePoke(word, Seconds(1234.5678));
  EXPECT_TRUE(poke.has_value()) << word;
  return poke ? *poke : Poke{};
}
double NumberOf(std::string_view word) { return std::get<double>(Parsed(word).value); }
std::string TextOfPoke(std::string_view word) { return std::get<std::string>(Parsed(word).value); }

TEST(ParsePoke, TakesWhatLooksLikeANumberForOne) {
  EXPECT_EQ(Parsed("SPEED=1.5").name, "SPEED");
  EXPECT_EQ(NumberOf("SPEED=1.5"), 1.5);
  EXPECT_EQ(NumberOf("A=-13.25"), -13.25);
  EXPECT_EQ(NumberOf("A=1e-3"), 1e-3);
  EXPECT_EQ(NumberOf("A=0"), 0.0);
  EXPECT_EQ(TextOfPoke("DEPLOY=true"), "true");
  EXPECT_EQ(TextOfPoke("A=1.5m"), "1.5m");
  EXPECT_EQ(TextOfPoke("A=nan"), "nan");
  EXPECT_EQ(TextOfPoke("A="), "");
}

TEST(ParsePoke, TakesAStringAsItStandsBehindAColon) {
  EXPECT_EQ(Parsed("A:=0012").name, "A");
  EXPECT_EQ(TextOfPoke("A:=0012"), "0012");
  EXPECT_EQ(TextOfPoke("A:=@UTC"), "@UTC");
  EXPECT_EQ(TextOfPoke("A:=\"x\""), "\"x\"");
}

TEST(ParsePoke, TakesQuotesForAString) {
  EXPECT_EQ(TextOfPoke("A=\"3\""), "3");
  EXPECT_EQ(TextOfPoke("A=\""), "\"");
}

TEST(ParsePoke, KeepsLaterEqualSignsAndColons) {
  EXPECT_EQ(TextOfPoke("A=points=1,2:3,4"), "points=1,2:3,4");
  EXPECT_EQ(Parsed("A=b:=c").name, "A");
  EXPECT_EQ(TextOfPoke("A=b:=c"), "b:=c");
}

TEST(ParsePoke, KnowsTheTime) {
  EXPECT_EQ(NumberOf("A=@MOOSTIME"), 1234.5678);
  EXPECT_EQ(NumberOf("A=@UTC"), 1234.5678);
  EXPECT_EQ(TextOfPoke("A=t=@MOOSTIME,u=@UTC"), "t=1234.57,u=1234.57");
}

TEST(ParsePoke, RefusesNamesThatNoBrokerShouldHave) {
  for (const char* word : {"", "A", "=3", ":=3", "A B=3", "A,B=3", "A\tB=3", "A\x7f=3"}) {
    EXPECT_FALSE(ParsePoke(word, Seconds(0)).has_value()) << word;
  }
  EXPECT_FALSE(ParsePoke("A\033B=3", Seconds(0)).has_value());
  EXPECT_FALSE(ParsePoke(std::string(1025, 'A') + "=3", Seconds(0)).has_value());
  EXPECT_THAT(ParsePoke("A\033B=3", Seconds(0)).error().text, HasSubstr("`A\\x1bB=3` has a name"));
}

Message Heard(const std::string& name, Value value, const std::string& source, std::int32_t id) {
  return {.name = name,
          .value = std::move(value),
          .time = Seconds(1),
          .source = source,
          .source_aux = "",
          .community = "",
          .id = id};
}

TEST(PokeResults, BelievesOnlyWhatComesBack) {
  const std::vector<Poke> pokes{{"A", 1.0}, {"B", 2.0}};
  const auto results = PokeResults(pokes, "me", {Heard("B", std::string("x"), "pB", -1)},
                                   {Heard("A", 1.0, "me", 5)});
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].outcome, PokeResult::Outcome::kWritten);
  EXPECT_FALSE(results[0].before.has_value());
  EXPECT_EQ(results[1].outcome, PokeResult::Outcome::kRefused);
  EXPECT_EQ(WhyRefused(results[1]),
            "B was refused: it holds a string, first written so, and a number was given; B:=2 "
            "writes a string");
}

TEST(PokeResults, IsNotFooledByAnotherWriterOfTheSameValue) {
  const auto results = PokeResults({{"A", 1.0}}, "me", {}, {Heard("A", 1.0, "pOther", 5)});
  EXPECT_EQ(results[0].outcome, PokeResult::Outcome::kRefused);
}

TEST(PokeResults, SeesItsWriteThoughAnotherFollows) {
  const auto results =
      PokeResults({{"A", 1.0}}, "me", {}, {Heard("A", 1.0, "me", 5), Heard("A", 9.0, "pB", 6)});
  EXPECT_EQ(results[0].outcome, PokeResult::Outcome::kWritten);
}

TEST(PokeResults, CountsTheLastOfSeveralPokes) {
  const auto results = PokeResults({{"A", 1.0}, {"A", 2.0}}, "me", {},
                                   {Heard("A", 1.0, "me", 5), Heard("A", 2.0, "me", 6)});
  ASSERT_EQ(results.size(), 1U);
  EXPECT_EQ(std::get<double>(results[0].after->value), 2.0);
}

}  // namespace
}  // namespace limpet
