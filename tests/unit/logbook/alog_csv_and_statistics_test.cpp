// SPDX-License-Identifier: MIT
// What is made of a log: statistics and CSV.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/logbook/alog_csv.hpp"
#include "limpet/logbook/alog_statistics.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;

AlogStatistics StatisticsOf(std::string_view text) {
  AlogStatistics statistics;
  AlogReader reader = AlogReader::OfText(text);
  AlogLine line;
  for (AlogEntry entry; reader.NextLine(line, entry);) {
    statistics.Add(line, entry);
  }
  return statistics;
}

std::string CsvOf(std::string_view text, AlogCsv::Join join) {
  AlogCsv table({"X", "Y"}, join);
  std::string out;
  table.AppendHeader(out);
  AlogReader reader = AlogReader::OfText(text);
  for (AlogEntry entry; reader.Next(entry);) {
    table.Append(out, entry);
  }
  table.AppendRest(out);
  return out;
}

TEST(AlogStatistics, DescribeEachVariable) {
  const AlogStatistics all =
      StatisticsOf("1.0 X pNav 2 \n3.0 X pSim 4 \n2.0 MODE pHelm a \nbroken\n5.0 X pNav 6 \n");
  const auto variables = all.Variables();
  ASSERT_EQ(variables.size(), 2U);
  EXPECT_EQ(variables[0].name, "MODE");
  EXPECT_EQ(variables[0].numbers.count, 0U);
  const VariableStatistics& x = variables[1];
  EXPECT_EQ(x.entries, 3U);
  EXPECT_THAT(x.sources, ElementsAre("pNav", "pSim"));
  EXPECT_DOUBLE_EQ(x.Rate(), 0.5);
  EXPECT_DOUBLE_EQ(x.longest_gap, 2.0);
  EXPECT_DOUBLE_EQ(x.numbers.mean, 4.0);
  EXPECT_DOUBLE_EQ(x.numbers.StandardDeviation(), std::sqrt(8.0 / 3.0));
  EXPECT_DOUBLE_EQ(x.numbers.least, 2.0);
  EXPECT_DOUBLE_EQ(x.numbers.greatest, 6.0);
  EXPECT_EQ(all.out_of_order(), 1U);
  EXPECT_DOUBLE_EQ(all.last(), 5.0);
}

constexpr std::string_view kTrack =
    "1.0 X p 1 \n1.0 Y p 2 \n1.5 OTHER p 9 \n2.0 X p 3 \n3.0 Y p a,\"b \n";

TEST(AlogCsv, HasARowPerEntryWithoutJoin) {
  EXPECT_EQ(CsvOf(kTrack, AlogCsv::Join::kNone),
            "time,X,Y\n1.00000,1,\n1.00000,,2\n2.00000,3,\n3.00000,,\"a,\"\"b\"\n");
}

TEST(AlogCsv, CarriesLastValuesOnAndJoinsAnInstant) {
  EXPECT_EQ(CsvOf(kTrack, AlogCsv::Join::kLast),
            "time,X,Y\n1.00000,1,2\n2.00000,3,2\n3.00000,3,\"a,\"\"b\"\n");
}

}  // namespace
}  // namespace limpet
