// SPDX-License-Identifier: MIT
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/logbook/alog_reader.hpp"
#include "limpet/logbook/gzip_file.hpp"
#include "limpet/logbook/log_folder.hpp"
#include "limpet/logbook/slog_writer.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;

constexpr Seconds kFilesStart{1767225600.0};

std::string TextOfFile(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::size_t EntriesIn(const std::filesystem::path& file) {
  AlogReader reader = *AlogReader::Open(file);
  std::size_t count = 0;
  for (AlogEntry entry; reader.Next(entry);) {
    ++count;
  }
  return count;
}

TEST(SlogWriter, RepeatsItsColumnNamesEveryThirtyRows) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "run.slog";
  {
    SlogWriter writer =
        *SlogWriter::Open(file, kFilesStart, {.names = {"NAV_X", "NAV_Y"}, .spare = 0}, {});
    for (int i = 1; i <= 31; ++i) {
      writer.WriteRow(i, {0.5, std::numeric_limits<double>::quiet_NaN()});
    }
    EXPECT_TRUE(writer.Sync());
  }
  const std::string text = TextOfFile(file);
  const std::string labels = "%% TIME            NAV_X              NAV_Y              \n";
  EXPECT_THAT(text,
              HasSubstr(labels + "1.00000            0.50000            NaN                \n"));
  EXPECT_THAT(text, HasSubstr(labels + "31.00000 "));
}

TEST(SlogWriter, HasOnlyAsManySpareColumnsAsItSaid) {
  const TemporaryFolder folder;
  SlogWriter writer =
      *SlogWriter::Open(folder.path() / "s", kFilesStart, {.names = {}, .spare = 1}, {});
  EXPECT_TRUE(writer.Claim("A"));
  EXPECT_FALSE(writer.Claim("B"));
}

TEST(LogFolder, IsNamedAsMoosDoes) {
  EXPECT_EQ(LogFolderStamp(Seconds(1795245600.0), false), "21_11_2026_____07_20_00");
  EXPECT_EQ(LogFolderStamp(Seconds(-5.0), false), "1_1_1970_____00_00_00");
}

TEST(LogFolder, IsAlwaysANewOne) {
  const TemporaryFolder folder;
  EXPECT_EQ(CreateLogFolder(folder.path() / "a/b", "L")->filename(), "L");
  EXPECT_EQ(CreateLogFolder(folder.path() / "a/b", "L")->filename(), "L_2");
  EXPECT_FALSE(CreateLogFolder("/proc/none", "L").has_value());
}

TEST(CompressedLog, IsReadAsThePlainOne) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "run.alog";
  std::ofstream(file) << "1.0 A p 1 \n2.0 A p 2 \n";
  ASSERT_TRUE(CompressFile(file));
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(EntriesIn(folder.path() / "run.alog.gz"), 2U);
}

TEST(CompressedLog, IsReadUpToItsTear) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "run.alog";
  {
    std::ofstream out(file);
    for (int i = 0; i < 200'000; ++i) {
      out << i << " A p " << (i * 7919) % 100'003 << " \n";
    }
  }
  ASSERT_TRUE(CompressFile(file));
  const auto packed = folder.path() / "run.alog.gz";
  std::filesystem::resize_file(packed, std::filesystem::file_size(packed) / 2);
  AlogReader reader = *AlogReader::Open(packed);
  std::size_t count = 0;
  for (AlogEntry entry; reader.Next(entry);) {
    ++count;
  }
  EXPECT_GT(count, 50'000U);
  EXPECT_FALSE(reader.has_failed());
}

}  // namespace
}  // namespace limpet
