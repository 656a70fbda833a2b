// SPDX-License-Identifier: MIT
#include "limpet/log_tools/column_table.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/log_tools/made_log.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(ColumnTable, PutsNumbersToTheRightAndNamesToTheLeft) {
  ColumnTable table({{"NAME", false}, {"N"}, {"BY", false}});
  table.Add({"a", "1", "x"});
  table.Add({"longer", "12345", "yy"});
  EXPECT_EQ(table.Text(false),
            "NAME        N  BY\n"
            "a           1  x\n"
            "longer  12345  yy\n");
}

TEST(ColumnTable, EndsEveryRightHandColumnAtOnePlace) {
  Random random(1, "columns");
  for (int run = 0; run < 200; ++run) {
    ColumnTable table({{"NAME", false}, {"COUNT"}});
    std::vector<std::size_t> lengths;
    for (int row = 0; row < 6; ++row) {
      table.Add({std::string(1 + random.Index(12), 'n'), std::string(1 + random.Index(9), '7')});
    }
    for (const std::string& line : LinesOf(table.Text(false)))
      lengths.push_back(line.size());
    EXPECT_THAT(lengths, ::testing::Each(lengths.front()));
  }
}

TEST(ColumnTable, CountsCharactersNotBytes) {
  ColumnTable table({{"NAME", false}, {"N"}});
  table.Add({"Ärger", "1"});
  table.Add({"plain", "1"});
  const auto lines = LinesOf(table.Text(false));
  EXPECT_EQ(lines[1].size(), lines[2].size() + 1) << "Ä has two bytes and one column";
}

TEST(ColumnTable, KeepsARowInOneLineWhateverItsCellsHold) {
  ColumnTable table({{"NAME", false}, {"N"}});
  table.Add({"two\nlines\033[31m", "1"});
  const std::string text = table.Text(false);
  EXPECT_EQ(LinesOf(text).size(), 2U);
  EXPECT_THAT(text, Not(HasSubstr("\033")));
}

TEST(ColumnTable, IsBoldInItsHeadOnlyWhereThereAreColours) {
  ColumnTable table({{"NAME", false}});
  table.Add({"a"});
  EXPECT_EQ(table.Text(true), "\033[1mNAME\033[0m\na\n");
  EXPECT_EQ(table.Text(false), "NAME\na\n");
}

TEST(Bytes, AreShownInTheUnitThatPeopleReadThem) {
  EXPECT_EQ(BytesText(0.0), "0 B");
  EXPECT_EQ(BytesText(999.0), "999 B");
  EXPECT_EQ(BytesText(1000.0), "1.0 kB");
  EXPECT_EQ(BytesText(99'949.0), "99.9 kB");
  EXPECT_EQ(BytesText(99'951.0), "100 kB");
  EXPECT_EQ(BytesText(999'500.0), "1.0 MB");
  EXPECT_EQ(BytesText(12'300'000.0), "12.3 MB");
  EXPECT_EQ(BytesText(5e15), "5000 TB") << "there is no greater unit";
}

TEST(Bytes, AreNeverShownWithMoreThanFourDigitsOrMoreThanHalfAUnitOff) {
  Random random(2, "bytes");
  for (int run = 0; run < 2000; ++run) {
    const double bytes = std::round(std::pow(10.0, random.Uniform(0.0, 14.9)));
    const std::string text = BytesText(bytes);
    const std::size_t blank = text.find(' ');
    const double shown = std::stod(text.substr(0, blank));
    const std::size_t thousands = std::string("BkMGT").find(text[blank + 1]);
    const double unit = std::pow(1000.0, static_cast<double>(thousands));
    EXPECT_NEAR(shown * unit, bytes, 0.0505 * unit + 0.0051 * bytes) << text;
    EXPECT_LE(blank, 4U) << text;
  }
}

TEST(Counts, AreGroupedInThreesFromTheRight) {
  EXPECT_EQ(CountText(0), "0");
  EXPECT_EQ(CountText(999), "999");
  EXPECT_EQ(CountText(1000), "1 000");
  EXPECT_EQ(CountText(1234567), "1 234 567");
  Random random(3, "counts");
  for (int run = 0; run < 500; ++run) {
    const std::uint64_t count = random.Bits() >> random.Index(64);
    std::string text = CountText(count);
    for (std::size_t i = 0; i < text.size(); ++i) {
      EXPECT_EQ(text[text.size() - 1 - i] == ' ', i % 4 == 3) << text;
    }
    std::erase(text, ' ');
    EXPECT_EQ(text, std::to_string(count));
  }
}

}  // namespace
}  // namespace limpet
