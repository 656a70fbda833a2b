// SPDX-License-Identifier: MIT
#include "limpet/logbook/alog_reader.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(AlogReader, SkipsWhatMoosToolsSkip) {
  AlogReader reader = AlogReader::OfText(
      "%% LOGSTART  100.5\nbroken line\n1.0 A\n2.0 A pNav\n3.0 A pNav 5.00000      \n"
      "1:02 A pNav 1\n\n4.0 B pNav:x:y  a \\n b \n");
  AlogEntry entry;
  ASSERT_TRUE(reader.Next(entry));
  EXPECT_EQ(entry.number, 5.0);
  ASSERT_TRUE(reader.Next(entry));
  EXPECT_EQ(entry.aux, "x:y");
  EXPECT_EQ(entry.value, "a \\n b") << "escapes are ours; a MOOS log has none";
  EXPECT_FALSE(reader.Next(entry));
  EXPECT_EQ(reader.start(), Seconds(100.5));
  EXPECT_EQ(reader.skipped_lines(), 4U);
}

TEST(AlogReader, DropsATornLastLine) {
  AlogReader reader = AlogReader::OfText("1.0 A pNav 1.0 \n2.0 A pNav 2.");
  AlogEntry entry;
  ASSERT_TRUE(reader.Next(entry));
  EXPECT_FALSE(reader.Next(entry));
  EXPECT_TRUE(reader.has_torn_end());
}

TEST(AlogReader, ReadsStringsMarkedAsSuch) {
  AlogReader reader = AlogReader::OfText("%% DATATYPE MARKING ON\n1.0 A p S:5 \n1.0 A p D:5 \n");
  AlogEntry entry;
  ASSERT_TRUE(reader.Next(entry));
  EXPECT_EQ(entry.value, "5");
  EXPECT_FALSE(entry.number.has_value());
  ASSERT_TRUE(reader.Next(entry));
  EXPECT_EQ(entry.number, 5.0);
}

TEST(AlogReader, ReadsWindowsLineEnds) {
  AlogReader reader = AlogReader::OfText("1.0 A p x \r\n");
  AlogEntry entry;
  ASSERT_TRUE(reader.Next(entry));
  EXPECT_EQ(entry.value, "x");
}

TEST(AlogReader, TakesTheIverLogsAsTheyAre) {
  const std::filesystem::path folder =
      std::filesystem::path(LIMPET_SOURCE_DIR) /
      "../shared/data/iver_umassd/simulation/iver__18_12_2016_____17_26_26";
  if (!std::filesystem::exists(folder)) {
    GTEST_SKIP() << "no shared data";
  }
  // Column extracts without names: not one line is an entry, and none may be mistaken for one.
  AlogReader extract = *AlogReader::Open(folder / "nav_xy.alog");
  AlogEntry entry;
  EXPECT_FALSE(extract.Next(entry));
  EXPECT_GT(extract.skipped_lines(), 1000U);
  AlogReader system = *AlogReader::Open(folder / "iver__18_12_2016_____17_26_26.ylog");
  while (system.Next(entry)) {
    EXPECT_FALSE(entry.name.empty());
  }
  ASSERT_TRUE(system.start().has_value());
  EXPECT_DOUBLE_EQ(system.start()->value(), 14820999866.9);
}

}  // namespace
}  // namespace limpet
