// SPDX-License-Identifier: MIT
// pLog as a process of a community: MOOS's folders and files, written by a thread.
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/pLog/log_app.hpp"
#include "limpet/logbook/alog_reader.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class LiveLogAppTest : public ::testing::Test {
 protected:
  LiveLogAppTest() {
    context_.name = "pLog";
    context_.link = &link_;
    context_.runs_live = true;
    params_.path = folder_.string();
    params_.file = "LOG_ALPHA";
    params_.has_time_stamp = false;
    params_.uses_utc = true;
    params_.summary_file = (folder_ / "last").string();
  }
  void Start() { app_.emplace(context_, params_); }
  /// Everything is on the disk after this.
  void End() {
    app_->Finish(link_.time);
    app_.reset();
  }
  void Send(const std::string& name, Value value) {
    app_->Deliver(std::make_shared<const Message>(Message{.name = name,
                                                          .value = std::move(value),
                                                          .time = link_.time,
                                                          .source = "pNav",
                                                          .source_aux = "",
                                                          .community = ""}));
  }
  [[nodiscard]] std::string Text(const std::string& name) const {
    std::ifstream in(folder_ / name);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  [[nodiscard]] std::vector<std::string> NamesIn(const std::string& name) const {
    std::vector<std::string> names;
    if (Expected<AlogReader> opened = AlogReader::Open(folder_ / name)) {
      AlogReader reader = *std::move(opened);
      for (AlogEntry entry; reader.Next(entry);) {
        names.emplace_back(entry.name);
      }
    }
    return names;
  }
  /// Rows of the .slog without comments, columns joined by commas.
  [[nodiscard]] std::vector<std::string> Rows() const {
    std::vector<std::string> rows;
    for (const std::string& line : Split(Text("LOG_ALPHA/LOG_ALPHA.slog"), '\n')) {
      std::string row;
      for (const std::string& word : Split(line, ' ')) {
        row += word.empty() ? "" : (row.empty() ? "" : ",") + word;
      }
      if (!row.empty() && row[0] != '%') {
        rows.push_back(row);
      }
    }
    return rows;
  }

  TemporaryFolder temporary_;
  std::filesystem::path folder_ = temporary_.path();
  TestLink link_;
  AppContext context_;
  LogApp::Params params_;
  std::optional<LogApp> app_;
};

TEST_F(LiveLogAppTest, NamesTheFolderByDate) {
  params_.has_time_stamp = true;
  Start();
  Send("NAV_X", 1.5);
  End();
  const std::string stem = "LOG_ALPHA_1_1_2026_____00_00_00";
  EXPECT_THAT(NamesIn(stem + "/" + stem + ".alog"), ElementsAre("NAV_X"));
}

TEST_F(LiveLogAppTest, NamesTheFolderByTheDateThatItIsUnderAWarp) {
  params_.has_time_stamp = true;
  context_.globals = {{"MOOSTimeWarp", "10", {}}};
  link_.time = Seconds(17672256000.0);
  Start();
  Send("NAV_X", 1.5);
  End();
  EXPECT_TRUE(std::filesystem::exists(folder_ / "LOG_ALPHA_1_1_2026_____00_00_00"));
}

TEST_F(LiveLogAppTest, TellsWhereItLogs) {
  Start();
  app_->Tick(link_.time);
  End();
  ASSERT_FALSE(link_.published.empty());
  EXPECT_EQ(link_.published[0]->name, "LOGGER_DIRECTORY");
  EXPECT_EQ(std::get<std::string>(link_.published[0]->value), (folder_ / "LOG_ALPHA").string());
  EXPECT_EQ(Text("last"), "LastOpenedLoggingDirectory=" + (folder_ / "LOG_ALPHA").string() + "\n");
}

TEST_F(LiveLogAppTest, GivesTheGlobalLogPathPrecedence) {
  context_.globals = {{"GlobalLogPath", (folder_ / "global").string(), {}}};
  Start();
  Send("NAV_X", 1.5);
  End();
  EXPECT_TRUE(std::filesystem::exists(folder_ / "global/LOG_ALPHA/LOG_ALPHA.alog"));
}

TEST_F(LiveLogAppTest, NeverWritesOverAFormerLog) {
  for (int run = 0; run < 2; ++run) {
    Start();
    Send("RUN_" + std::to_string(run), 1.5);
    End();
  }
  EXPECT_THAT(NamesIn("LOG_ALPHA/LOG_ALPHA.alog"), ElementsAre("RUN_0"));
  EXPECT_THAT(NamesIn("LOG_ALPHA_2/LOG_ALPHA_2.alog"), ElementsAre("RUN_1"));
}

/// A logger that was killed, and the one that takes its place.
class RestartedLogAppTest : public LiveLogAppTest {
 protected:
  RestartedLogAppTest() {
    context_.run_folder = folder_ / "run";
    std::filesystem::create_directories(context_.run_folder);
    params_.logs_binaries = "true";
  }
  void LiveOnce() {
    Start();
    link_.time += Seconds(1.0);
    Send("NAV_X", 1.5);
    Send("FRAME", Binary{std::byte{'a'}, std::byte{'b'}});
    link_.time += Seconds(1.0);
    Send("DEPLOY", std::string("true"));
    End();
  }
  void StartAgain() {
    context_.is_restarted = true;
    Start();
  }
  const std::string log_ = "LOG_ALPHA/LOG_ALPHA.alog";
};

TEST_F(RestartedLogAppTest, GoesOnInTheSameLog) {
  LiveOnce();
  StartAgain();
  link_.time += Seconds(3.0);
  Send("NAV_X", 2.5);
  Send("FRAME", Binary{std::byte{'c'}});
  End();
  EXPECT_THAT(NamesIn(log_), ElementsAre("NAV_X", "FRAME", "DEPLOY", "NAV_X", "FRAME"));
  EXPECT_THAT(Text(log_), HasSubstr("\n5.00000         NAV_X"));
  EXPECT_EQ(Text("LOG_ALPHA/LOG_ALPHA.blog"), "abc");
}

TEST_F(RestartedLogAppTest, DoesNotRepeatWhatStandsThere) {
  LiveOnce();
  StartAgain();
  Send("DEPLOY", std::string("true"));  // the broker sends every latest value
  link_.time += Seconds(0.1);
  Send("RETURN", std::string("true"));
  End();
  EXPECT_THAT(NamesIn(log_), ElementsAre("NAV_X", "FRAME", "DEPLOY", "RETURN"));
}

TEST_F(RestartedLogAppTest, CutsOffHalfALine) {
  LiveOnce();
  std::ofstream(folder_ / log_, std::ios::app) << "2.50000         NAV_X           pNav      1.2";
  StartAgain();
  link_.time += Seconds(3.0);
  Send("NAV_Y", 2.5);
  End();
  EXPECT_THAT(NamesIn(log_), ElementsAre("NAV_X", "FRAME", "DEPLOY", "NAV_Y"));
}

TEST_F(RestartedLogAppTest, BeginsALogIfItsFormerOneIsGone) {
  LiveOnce();
  std::filesystem::remove_all(folder_ / "LOG_ALPHA");
  StartAgain();
  Send("NAV_X", 2.5);
  End();
  EXPECT_THAT(NamesIn(log_), ElementsAre("NAV_X"));
}

TEST_F(LiveLogAppTest, PutsWhatPatternsLeaveOutIntoTheXlog) {
  params_.wildcard_omit_patterns = {"*_STATUS"};
  params_.has_exclusion_log = true;
  Start();
  Send("NAV_X", 1.0);
  Send("PNAV_STATUS", std::string("fine\nindeed"));
  End();
  EXPECT_THAT(NamesIn("LOG_ALPHA/LOG_ALPHA.alog"), ElementsAre("NAV_X"));
  EXPECT_THAT(NamesIn("LOG_ALPHA/LOG_ALPHA.xlog"), ElementsAre("PNAV_STATUS"));
}

TEST_F(LiveLogAppTest, PutsSystemMessagesIntoTheYlogToo) {
  Start();
  Send("MOOS_DEBUG", std::string("pHelm: stopped"));
  Send("NAV_X", 1.0);
  End();
  EXPECT_THAT(NamesIn("LOG_ALPHA/LOG_ALPHA.ylog"), ElementsAre("MOOS_DEBUG"));
  EXPECT_THAT(NamesIn("LOG_ALPHA/LOG_ALPHA.alog"), ElementsAre("MOOS_DEBUG", "NAV_X"));
}

TEST_F(LiveLogAppTest, LogsBinariesAsMoosDoes) {
  Start();
  Send("FRAME", Binary{std::byte{1}, std::byte{2}});
  End();
  EXPECT_EQ(Text("LOG_ALPHA/LOG_ALPHA.blog"), "\x01\x02");
  EXPECT_THAT(Text("LOG_ALPHA/LOG_ALPHA.alog"), HasSubstr("File=LOG_ALPHA.blog,Offset=0,Bytes=2<"));
}

TEST_F(LiveLogAppTest, WritesATableOfTheLogVariables) {
  params_.sync_log = "true @ 0.5";
  params_.logged = {"NAV_X @ 0", "NAV_Y @ 0, NOSYNC", "MODE @ 0"};
  Start();
  Send("NAV_X", 1.0);
  Send("NAV_Y", 9.0);
  link_.time += Seconds(0.4);
  Send("NAV_X", 2.0);
  link_.time += Seconds(0.15);
  app_->Tick(link_.time);
  link_.time += Seconds(0.5);
  Send("MODE", std::string("ACTIVE"));
  End();
  EXPECT_THAT(Rows(), ElementsAre("0.50000,2.00000,NaN", "1.00000,NaN,NaN"));
  EXPECT_THAT(Text("LOG_ALPHA/LOG_ALPHA.slog"),
              HasSubstr("%%   (1) TIME \n%%   (2) NAV_X\n%%   (3) MODE\n"));
}

TEST_F(LiveLogAppTest, NamesASpareColumnOnRequest) {
  params_.sync_log = "true @ 0.5";
  params_.wildcard_logging = false;
  params_.logged = {"NAV_X"};
  params_.spare_columns = 2;
  Start();
  Send("NAV_X", 1.0);
  Send("PLOGGER_CMD", std::string("LOG_REQUEST = DEPTH @ 0"));
  Send("DEPTH", 7.0);
  link_.time += Seconds(0.5);
  app_->Tick(link_.time);
  End();
  EXPECT_THAT(Rows(), ElementsAre("0.50000,1.00000,7.00000,NaN"));
  EXPECT_THAT(Text("LOG_ALPHA/LOG_ALPHA.slog"), HasSubstr("%%   (3) DEPTH   "));
  EXPECT_THAT(NamesIn("LOG_ALPHA/LOG_ALPHA.alog"), ElementsAre("NAV_X", "DEPTH"));
}

TEST_F(LiveLogAppTest, KeepsACopyOfTheMissionAndOfWhatIsAskedFor) {
  std::ofstream(folder_ / "alpha.moos") << "Community = alpha\n";
  std::ofstream(folder_ / "alpha.bhv") << "Behavior = BHV_X\n";
  context_.mission_file = folder_ / "alpha.moos";
  Start();
  std::ofstream(folder_ / "more.bhv") << "Behavior = BHV_Y\n";
  Send("PLOGGER_CMD", "COPY_FILE_REQUEST = " + (folder_ / "alpha.bhv").string());
  Send("PLOGGER_CMD", std::string("COPY_FILE_REQUEST = more.bhv"));
  Send("PLOGGER_CMD", std::string("COPY_FILE_REQUEST = /no/such/file"));
  End();
  EXPECT_EQ(Text("LOG_ALPHA/LOG_ALPHA._moos"), "Community = alpha\n");
  EXPECT_EQ(Text("LOG_ALPHA/alpha._bhv"), "Behavior = BHV_X\n");
  EXPECT_EQ(Text("LOG_ALPHA/more._bhv"), "Behavior = BHV_Y\n") << "as a helm names it";
  EXPECT_THAT(Text("LOG_ALPHA/LOG_ALPHA.alog"), HasSubstr("%% file is not copied: no such file\n"));
}

TEST_F(LiveLogAppTest, CopiesNothingThatIsNotTheMissionsOrTheRuns) {
  const std::filesystem::path mission = folder_ / "mission";
  std::filesystem::create_directories(mission / ".ssh");
  std::ofstream(mission / ".ssh" / "id_rsa") << "secret\n";
  std::ofstream(folder_ / "neighbour.txt") << "secret\n";
  std::ofstream(mission / "alpha.bhv") << "Behavior = BHV_X\n";
  std::filesystem::create_symlink("/etc/passwd", mission / "link.txt");
  context_.mission_file = mission / "alpha.moos";
  std::ofstream(context_.mission_file) << "Community = alpha\n";
  Start();
  const std::vector<std::filesystem::path> refused = {"/etc/passwd",
                                                      mission / "link.txt",
                                                      "/dev/zero",
                                                      mission / "../neighbour.txt",
                                                      mission / ".ssh/id_rsa",
                                                      mission};
  for (const std::filesystem::path& path : refused) {
    const std::string name = path.string();
    Send("PLOGGER_CMD", "COPY_FILE_REQUEST = " + name);
    EXPECT_THAT(app_->warnings().at("COPY_REFUSED").text,
                HasSubstr("of `" + name + "`, by pNav: no"));
  }
  ReportLines report;
  app_->Report(report);
  EXPECT_THAT(report.Text(), HasSubstr("0 at request, 6 refused"));
  link_.time += Seconds(61.0);
  app_->Tick(link_.time);
  EXPECT_FALSE(app_->warnings().contains("COPY_REFUSED"));
  Send("PLOGGER_CMD", "COPY_FILE_REQUEST = " + (mission / "alpha.bhv").string());
  End();
  std::vector<std::string> copies;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "LOG_ALPHA")) {
    if (entry.path().extension().string().starts_with("._")) {
      copies.push_back(entry.path().filename().string());
    }
  }
  EXPECT_THAT(copies, testing::UnorderedElementsAre("LOG_ALPHA._moos", "alpha._bhv"));
  EXPECT_THAT(Text("LOG_ALPHA/LOG_ALPHA.alog"),
              HasSubstr("%% passwd is not copied: not a visible"));
}

TEST_F(LiveLogAppTest, CopiesOnlySoManyFiles) {
  context_.mission_file = folder_ / "alpha.moos";
  std::ofstream(context_.mission_file) << "Community = alpha\n";
  Start();
  for (int i = 0; i < 65; ++i) {
    const std::string name = "f" + std::to_string(i) + ".txt";
    std::ofstream(folder_ / name) << i;
    Send("PLOGGER_CMD", "COPY_FILE_REQUEST = " + (folder_ / name).string());
  }
  EXPECT_THAT(app_->warnings().at("COPY_REFUSED").text, HasSubstr("more than 64 copies"));
  End();
  EXPECT_FALSE(std::filesystem::exists(folder_ / "LOG_ALPHA/f64._txt"));
}

TEST_F(LiveLogAppTest, BeginsANewSessionWhenToldTo) {
  Start();
  Send("BEFORE", 1.0);
  Send("LOGGER_RESTART", 1.0);
  Send("AFTER", 1.0);
  End();
  EXPECT_THAT(NamesIn("LOG_ALPHA/LOG_ALPHA.alog"), ElementsAre("BEFORE"));
  EXPECT_THAT(NamesIn("LOG_ALPHA_2/LOG_ALPHA_2.alog"), ElementsAre("LOGGER_RESTART", "AFTER"));
}

TEST_F(LiveLogAppTest, CompressesTheLogAtItsEnd) {
  params_.compresses = true;
  Start();
  Send("NAV_X", 1.0);
  End();
  EXPECT_FALSE(std::filesystem::exists(folder_ / "LOG_ALPHA/LOG_ALPHA.alog"));
  EXPECT_THAT(NamesIn("LOG_ALPHA/LOG_ALPHA.alog.gz"), ElementsAre("NAV_X"));
}

TEST_F(LiveLogAppTest, WarnsOfACommandThatMeansNothingUntilOneIsObeyed) {
  Start();
  Send("PLOGGER_CMD", std::string("DANCE"));
  EXPECT_THAT(app_->warnings().at("BAD_COMMAND").text, HasSubstr("`DANCE`"));
  Send("PLOGGER_CMD", std::string("LOG_REQUEST = NAV_X @ often"));
  EXPECT_THAT(app_->warnings().at("BAD_COMMAND").text, HasSubstr("often"));
  Send("PLOGGER_CMD", std::string("LOG_REQUEST = NAV_X @ 0"));
  EXPECT_FALSE(app_->warnings().contains("BAD_COMMAND"));
  End();
}

TEST_F(LiveLogAppTest, WarnsWhileThereIsNoPlaceForALog) {
  const std::filesystem::path home = std::filesystem::current_path();
  std::filesystem::create_directory(folder_ / "gone");
  std::filesystem::current_path(folder_ / "gone");  // the place for want of a better
  std::filesystem::remove(folder_ / "gone");
  params_.path = (folder_ / "logs").string();
  std::ofstream(params_.path) << "no folder\n";
  Start();
  Send("NAV_X", 1.0);
  std::filesystem::current_path(home);
  EXPECT_TRUE(app_->warnings().contains("LOG_FAILED"));
  EXPECT_TRUE(app_->warnings().contains("LOG_FOLDER"));
  std::filesystem::remove(params_.path);
  Send("LOGGER_RESTART", 1.0);
  app_->Tick(link_.time);
  EXPECT_FALSE(app_->warnings().contains("LOG_FAILED"));
  EXPECT_FALSE(app_->warnings().contains("LOG_FOLDER"));
  End();
}

TEST_F(LiveLogAppTest, WarnsWhileAMonitoredVariableIsSilent) {
  params_.logged = {"NAV_X @ 0, MONITOR"};
  Start();
  link_.time += Seconds(11.0);
  app_->Tick(link_.time);
  EXPECT_TRUE(app_->warnings().contains("SILENT_NAV_X"));
  Send("NAV_X", 1.0);
  EXPECT_FALSE(app_->warnings().contains("SILENT_NAV_X"));
  End();
}

}  // namespace
}  // namespace limpet
