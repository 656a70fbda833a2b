// SPDX-License-Identifier: MIT
#include "limpet/logbook/logs_below.hpp"

#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/logbook/alog_writer.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;

fs::path LogThatBegins(const fs::path& file, double start) {
  fs::create_directories(file.parent_path());
  static_cast<void>(*AlogWriter::Open(file, Seconds(start), {}));
  return file;
}

TEST(LogsBelow, AreOfEveryFolderPackedOrNotByPath) {
  const TemporaryFolder run;
  const fs::path later = LogThatBegins(run.path() / "discovery" / "b.alog", 5.0);
  const fs::path packed = run.path() / "discovery" / "a.alog.gz";
  const fs::path above = LogThatBegins(run.path() / "change.alog", 9.0);
  std::ofstream(packed) << "";
  std::ofstream(run.path() / "discovery" / "b.blog") << "";
  fs::create_directory(run.path() / "folder.alog");

  EXPECT_THAT(LogsBelow(run.path()), ElementsAre(above, packed, later));
}

TEST(LogsBelow, SayByTheirBannerWhenTheyBegan) {
  const TemporaryFolder run;
  EXPECT_EQ(StartOfLog(LogThatBegins(run.path() / "run.alog", 1767225600.0)),
            Seconds(1767225600.0));
}

TEST(LogsBelow, BeganAtNoughtIfNothingSaysWhen) {
  const TemporaryFolder run;
  const fs::path foreign = run.path() / "foreign.alog";
  std::ofstream(foreign) << "0.5 NAV_X pNav 1\n";

  EXPECT_EQ(StartOfLog(foreign), Seconds(0.0));
  EXPECT_EQ(StartOfLog(run.path() / "absent.alog"), Seconds(0.0));
}

TEST(LogsBelow, TheLatestIsTheOneThatBeganLast) {
  const TemporaryFolder run;
  const fs::path first = LogThatBegins(run.path() / "a.alog", 10.0);
  const fs::path last = LogThatBegins(run.path() / "b.alog", 30.0);
  const fs::path second = LogThatBegins(run.path() / "c.alog", 20.0);

  EXPECT_EQ(LatestLog({first, last, second}), last);
}

}  // namespace
}  // namespace limpet
