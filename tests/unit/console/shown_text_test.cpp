// SPDX-License-Identifier: MIT
#include "limpet/console/shown_text.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(OneLine, ShowsControlCharactersInsteadOfObeyingThem) {
  EXPECT_EQ(OneLine("a\033[2Jb\nc\td\x7f"), "a\\x1b[2Jb\\nc\\td\\x7f");
  EXPECT_EQ(OneLine(std::string_view("\0\x07", 2)), "\\x00\\x07");
}

TEST(ShownLines, KeepsEndsOfLinesAndNothingElseThatATerminalObeys) {
  EXPECT_EQ(ShownLines("a\033[2J\n\tb\n"), "a\\x1b[2J\n\\tb\n");
  EXPECT_EQ(ShownLines("one"), "one");
}

TEST(OneLine, ShowsEightBitControlsAlsoAsUtf8) {
  EXPECT_EQ(OneLine("\x9b"
                    "2J"),
            "\\x9b2J");
  EXPECT_EQ(OneLine("\xc2\x9b"
                    "2J"),
            "\\u009b2J");
}

TEST(OneLine, ShowsWhatTurnsTextAround) { EXPECT_EQ(OneLine("a\u202eb"), "a\\u202eb"); }

TEST(OneLine, KeepsLettersOfOneColumn) { EXPECT_EQ(OneLine("größe ±5° Ωж"), "größe ±5° Ωж"); }

TEST(OneLine, ShowsWideAndCombiningCharactersByNumber) {
  EXPECT_EQ(OneLine("漢e\u0301"), "\\u6f22e\\u0301");
}

TEST(OneLine, IsAsciiOnTerminalsWithoutUtf8) {
  EXPECT_EQ(OneLine("größe", kAnyWidth, false), "gr\\u00f6\\u00dfe");
}

TEST(OneLine, ShowsBytesThatAreNoUtf8) {
  EXPECT_EQ(OneLine("\xff\xc3"), "\\xff\\xc3");
  EXPECT_EQ(OneLine("\xc0\xaf"), "\\xc0\\xaf") << "overlong";
  EXPECT_EQ(OneLine("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "surrogate";
}

TEST(OneLine, MarksWhatItCutsOff) {
  EXPECT_EQ(OneLine("abcdef", 6), "abcdef");
  EXPECT_EQ(OneLine("abcdefg", 6), "abcde~");
  EXPECT_EQ(OneLine("abc", 1), "~");
  EXPECT_EQ(OneLine("abc", 0), "");
}

TEST(OneLine, NeverCutsThroughAnEscapeNorExceedsItsWidth) {
  EXPECT_EQ(OneLine("abcd\nef", 6), "abcd~");
  for (std::size_t width = 0; width < 20; ++width) {
    EXPECT_LE(ColumnsOf(OneLine("ab\033cd\u202eö漢\xff", width)), width);
  }
}

KeptValue Kept(Value value) { return KeptValue::Of(value); }

TEST(ShownValue, WritesNumbersForPeople) {
  EXPECT_EQ(ShownValue(Kept(12.0)), "12");
  EXPECT_EQ(ShownValue(Kept(-0.1)), "-0.1");
  EXPECT_EQ(ShownValue(Kept(1.23456789)), "1.234568");
  EXPECT_EQ(ShownValue(Kept(8976376422.413301)), "8976376422.413301");
  EXPECT_EQ(ShownValue(Kept(5.254368098648952e-05)), "5.25437e-05");
  EXPECT_EQ(ShownValue(Kept(1e300)), "1e+300");
  EXPECT_EQ(ShownValue(Kept(std::nan(""))), "nan");
}

TEST(ShownValue, SaysHowBigABinaryIs) {
  EXPECT_EQ(ShownValue(Kept(Binary(1400, std::byte{0xAB}))),
            "[1.4 kB] abababab abababab abababab abababab ...");
  EXPECT_EQ(ShownValue(Kept(Binary{std::byte{1}})), "[1 B] 01");
}

TEST(ShownValue, SaysHowBigALongTextIs) {
  const KeptValue value = Kept(std::string(10'000, 'x'));
  EXPECT_EQ(value.head.size(), KeptValue::kMostBytes);
  EXPECT_EQ(ShownValue(value, 20), "[10.0 kB] xxxxxxxxx~");
}

TEST(KeptValue, NoticesAChangeFarBehind) {
  std::string text(10'000, 'x');
  const KeptValue before = Kept(text);
  text.back() = 'y';
  EXPECT_NE(Kept(text), before);
}

TEST(KeptValue, TellsTypesApart) {
  EXPECT_NE(Kept(std::string("a")), Kept(Binary{std::byte{'a'}}));
}

TEST(ShownAge, FitsSixColumns) {
  EXPECT_EQ(ShownAge(Seconds(0.04)), "0.0");
  EXPECT_EQ(ShownAge(Seconds(99.9)), "99.9");
  EXPECT_EQ(ShownAge(Seconds(99.96)), "1m39");
  EXPECT_EQ(ShownAge(Seconds(725)), "12m05");
  EXPECT_EQ(ShownAge(Seconds(11'220)), "3h07");
  EXPECT_EQ(ShownAge(Seconds(4e5)), "4d15");
  EXPECT_EQ(ShownAge(Seconds(1.7e9)), "old");
  EXPECT_EQ(ShownAge(Seconds(-3)), "0.0");
  for (double age = 0.01; age < 1e12; age *= 1.7) {
    EXPECT_LE(ShownAge(Seconds(age)).size(), 6U) << age;
  }
}

TEST(ShownRate, HasThreeDigits) {
  EXPECT_EQ(ShownRate(0.0), "-");
  EXPECT_EQ(ShownRate(0.001), "<0.01");
  EXPECT_EQ(ShownRate(0.5), "0.50");
  EXPECT_EQ(ShownRate(9.999), "10.0");
  EXPECT_EQ(ShownRate(99.96), "100");
  EXPECT_EQ(ShownRate(1e9), "999999");
}

}  // namespace
}  // namespace limpet
