// SPDX-License-Identifier: MIT
#include "apps/pLog/log_app.hpp"

#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/app/registry.hpp"
#include "limpet/logbook/alog_reader.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;

class LogAppTest : public ::testing::Test {
 protected:
  LogAppTest() {
    context_.name = "pLog";
    context_.link = &link_;
    context_.run_folder = folder_;
    context_.session = "discovery";
  }

  void Send(App& app, const std::string& name, Value value) const {
    app.Deliver(std::make_shared<const Message>(Message{.name = name,
                                                        .value = std::move(value),
                                                        .time = link_.time,
                                                        .source = "pNav",
                                                        .source_aux = "",
                                                        .community = ""}));
  }
  [[nodiscard]] std::vector<std::string> Logged() const {
    Expected<AlogReader> opened = AlogReader::Open(folder_ / "discovery.alog");
    if (!opened) {
      return {};
    }
    AlogReader reader = *std::move(opened);
    std::vector<std::string> names;
    for (AlogEntry entry; reader.Next(entry);) {
      names.emplace_back(entry.name);
    }
    return names;
  }
  [[nodiscard]] std::string Bytes() const {
    std::ifstream in(folder_ / "discovery.alog");
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }

  TemporaryFolder temporary_;
  std::filesystem::path folder_ = temporary_.path() / "run";
  TestLink link_;
  AppContext context_;
};

TEST_F(LogAppTest, LogsEverythingButBinaries) {
  LogApp app(context_, {});
  Send(app, "NAV_X", 1.0);
  Send(app, "CAMERA_FRAME", Binary{std::byte{1}});
  Send(app, "MODE", std::string("ACTIVE"));
  app.Finish(link_.time);
  EXPECT_THAT(Logged(), ElementsAre("NAV_X", "MODE"));
}

TEST_F(LogAppTest, HasTheFileReadableAfterATick) {
  LogApp app(context_, {});
  Send(app, "NAV_X", 1.0);
  app.Tick(link_.time);
  EXPECT_THAT(Logged(), ElementsAre("NAV_X"));
}

TEST_F(LogAppTest, LeavesNothingBeforeTheFirstMessage) {
  LogApp app(context_, {});
  app.Tick(link_.time);
  EXPECT_FALSE(std::filesystem::exists(folder_));
}

TEST_F(LogAppTest, FollowsPatternsAndOmissions) {
  LogApp::Params params;
  params.wildcard_patterns = {"NAV_*, MODE"};
  params.wildcard_omit_patterns = {"*_SPEED"};
  LogApp app(context_, params);
  for (const char* name : {"NAV_X", "NAV_SPEED", "MODE", "DEPLOY"}) {
    Send(app, name, 1.0);
  }
  app.Finish(link_.time);
  EXPECT_THAT(Logged(), ElementsAre("NAV_X", "MODE"));
}

TEST_F(LogAppTest, LogsAListedVariableAtMostAtItsRate) {
  LogApp::Params params;
  params.wildcard_logging = false;
  params.logged = {"NAV_X @ 1.0, NOSYNC"};
  LogApp app(context_, params);
  for (int i = 0; i < 5; ++i) {
    Send(app, "NAV_X", static_cast<double>(i));
    link_.time += Seconds(0.5);
  }
  app.Finish(link_.time);
  EXPECT_THAT(link_.subscriptions, ElementsAre("NAV_X"));
  EXPECT_EQ(Logged().size(), 3U);
}

TEST_F(LogAppTest, WritesTheSameBytesForTheSameMail) {
  const auto run = [this] {
    TestLink link;
    context_.link = &link;
    LogApp app(context_, {});
    Send(app, "NAV_X", 1.5);
    app.Finish(link.time);
    return Bytes();
  };
  const std::string first = run();
  EXPECT_EQ(first, run());
  EXPECT_EQ(first.find(folder_.string()), std::string::npos) << "no absolute path in a log";
}

TEST_F(LogAppTest, WarnsWhenTheLogCannotBeCreated) {
  context_.run_folder = "/proc/no_such_folder";
  LogApp app(context_, {});
  Send(app, "NAV_X", 1.0);
  EXPECT_TRUE(app.warnings().contains("LOG_FAILED"));
}

TEST_F(LogAppTest, RefusesALogLineWithoutRate) {
  LogApp::Params params;
  params.logged = {"NAV_X @ often"};
  EXPECT_THROW(LogApp(context_, params), ConfigError);
}

TEST_F(LogAppTest, ReadsAMoosLoggerBlock) {
  ConfigBlock block{.name = "pLog", .where = {}, .entries = {}};
  for (const auto& [key, value] :
       std::vector<std::pair<std::string, std::string>>{{"AsyncLog", "true"},
                                                        {"Log", "NAV_X @ 0.1, NOSYNC"},
                                                        {"WildCardLogging", "true"},
                                                        {"WildCardOmitPattern", "*_STATUS"},
                                                        {"WildCardOmitPattern", "DB_VARSUMMARY"},
                                                        {"LogAuxSrc", "true"},
                                                        {"DoublePrecision", "8"},
                                                        {"FileTimeStamp", "true"},
                                                        {"File", "LOG_A"}}) {
    block.entries.push_back({key, value, {"m.moos", 1}});
  }
  const auto params = ReadParams<LogApp::Params>(block, CommonAppKeys());
  EXPECT_EQ(params.double_precision, 8);
  EXPECT_THAT(params.wildcard_omit_patterns, ElementsAre("*_STATUS", "DB_VARSUMMARY"));
}

TEST_F(LogAppTest, TellsTheOperatorWhatIsLogged) {
  LogParams params;
  params.wildcard_omit_patterns = {"CAMERA_FRAME"};
  LogApp app(context_, params);
  Send(app, "NAV_X", 1.0);
  ReportLines lines;
  app.Report(lines);
  EXPECT_THAT(lines.Text(), ::testing::HasSubstr("Log:          open"));
  EXPECT_THAT(lines.Text(), ::testing::HasSubstr("Variables:    * without CAMERA_FRAME"));
}

}  // namespace
}  // namespace limpet
