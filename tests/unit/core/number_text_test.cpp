// SPDX-License-Identifier: MIT
#include "limpet/core/number_text.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

TEST(NumberText, BringsBackEveryFiniteDoubleBitByBit) {
  Random random(1);
  int finite = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<double>(random.Bits());
    if (!std::isfinite(value)) continue;
    ++finite;
    const auto back = ParseNumber(TextOf(value));
    ASSERT_TRUE(back) << TextOf(value);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(value));
  }
  EXPECT_GT(finite, 15000);
}

TEST(NumberText, IsTheShortestThatBringsTheNumberBack) {
  EXPECT_EQ(TextOf(0.1), "0.1");
  EXPECT_EQ(TextOf(-2.0), "-2");
  EXPECT_EQ(TextOf(1e300), "1e+300");
  EXPECT_EQ(TextOf(1.0 / 3.0), "0.3333333333333333");
}

TEST(NumberText, OfWhatIsNoNumberIsNotTakenForOne) {
  EXPECT_FALSE(ParseNumber(TextOf(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_FALSE(ParseNumber(TextOf(std::numeric_limits<double>::infinity())));
}

class NoNumber : public ::testing::TestWithParam<const char*> {};

TEST_P(NoNumber, IsRefused) {
  EXPECT_FALSE(ParseNumber(GetParam())) << GetParam();
  EXPECT_FALSE(ParseInteger(GetParam())) << GetParam();
}

INSTANTIATE_TEST_SUITE_P(Text, NoNumber,
                         ::testing::Values("", " ", "x", "1x", "1 2", "--1", "++1", "+-1", "-+1",
                                           "1,5", "0x10", "1e", "e5", ".", "+", "-", "nan", "inf",
                                           "1e999", "1m"));

TEST(ParseNumber, TakesBlanksAroundAndAPlus) {
  EXPECT_EQ(ParseNumber(" \t3.5 "), 3.5);
  EXPECT_EQ(ParseNumber("+3.5"), 3.5);
  EXPECT_EQ(ParseNumber(".5"), 0.5);
  EXPECT_EQ(ParseNumber("-1e-3"), -1e-3);
}

TEST(ParseInteger, BringsBackEveryIntegerAndNothingBeyond) {
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    const auto value = std::bit_cast<std::int64_t>(random.Bits());
    EXPECT_EQ(ParseInteger(std::to_string(value)), value);
  }
  EXPECT_EQ(ParseInteger("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
  EXPECT_FALSE(ParseInteger("9223372036854775808"));
  EXPECT_FALSE(ParseInteger("3.0"));
  EXPECT_FALSE(ParseInteger("1e3"));
}

TEST(ParseFlag, TakesWordsInAnyCaseAndNumbersAsMoosDoes) {
  for (const char* yes : {"true", "YES", "On", "1", "0.5", " true "})
    EXPECT_EQ(ParseFlag(yes), true) << yes;
  for (const char* no : {"false", "NO", "Off", "0", "-1", " off "})
    EXPECT_EQ(ParseFlag(no), false) << no;
  for (const char* neither : {"", "maybe", "tru", "yess", "nan"})
    EXPECT_FALSE(ParseFlag(neither)) << neither;
}

}  // namespace
}  // namespace limpet
