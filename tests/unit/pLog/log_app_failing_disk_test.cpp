// SPDX-License-Identifier: MIT
// pLog on a disk that is full, fails or is read-only for a while: nothing that is missing goes
// unsaid.
#include <algorithm>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/pLog/log_app.hpp"
#include "limpet/durable/failing_file_system.hpp"
#include "limpet/logbook/alog_reader.hpp"
#include "limpet/logbook/blog.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_link.hpp"
#include "tests/support/torn_disk.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using Fault = FailingFileSystem::Fault;

class LogOnAFailingDisk : public ::testing::TestWithParam<Fault> {
 protected:
  LogOnAFailingDisk() {
    context_.name = "pLog";
    context_.link = &link_;
    context_.run_folder = folder_.path() / "run";
    context_.session = "discovery";
    context_.disk = &disk_;
  }
  /// Messages of this many bytes.
  void Send(int count, std::size_t size) {
    for (int i = 0; i < count; ++i) {
      app_->Deliver(std::make_shared<const Message>(Message{.name = "TEXT",
                                                            .value = std::string(size, 'x'),
                                                            .time = link_.time,
                                                            .source = "test",
                                                            .source_aux = "",
                                                            .community = ""}));
    }
    sent_ += count;
  }
  void Tick() {
    link_.time += Seconds(1.0);
    app_->Tick(link_.time);
  }
  [[nodiscard]] std::filesystem::path File() const {
    return context_.run_folder / "discovery.alog";
  }
  [[nodiscard]] std::string Text() const {
    std::ifstream in(File());
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  [[nodiscard]] int Logged() const {
    Expected<AlogReader> reader = AlogReader::Open(File());
    int count = 0;
    for (AlogEntry entry; reader && reader->Next(entry);) {
      ++count;
    }
    return count;
  }

  TemporaryFolder folder_;
  FailingFileSystem disk_{RealFileSystem()};
  TestLink link_;
  AppContext context_;
  std::optional<LogApp> app_;
  int sent_ = 0;
};

TEST_P(LogOnAFailingDisk, LosesNothingThatWaitsForItToRecover) {
  app_.emplace(context_, LogApp::Params{});
  Send(10, 50);
  Tick();
  disk_.Set(GetParam());
  Send(10, 50);
  Tick();
  EXPECT_THAT(app_->warnings().at("LOG_FAILED").text, HasSubstr("; 10 messages wait, 0 are"));
  EXPECT_FALSE(link_.Last(topics::kLogState)->is_written);
  disk_.Set(Fault::kNone);
  Tick();
  EXPECT_FALSE(app_->warnings().contains("LOG_FAILED"));
  EXPECT_FALSE(app_->warnings().contains("LOG_DROPPED"));
  EXPECT_TRUE(link_.Last(topics::kLogState)->is_written);
  EXPECT_EQ(Logged(), sent_);
}

TEST_P(LogOnAFailingDisk, CountsWhatItHadToDropAndSaysSoInTheLog) {
  app_.emplace(context_, LogApp::Params{});
  Send(10, 50);
  Tick();
  disk_.Set(GetParam());
  Send(60, 100'000);
  Tick();
  Send(5, 50);
  disk_.Set(Fault::kNone);
  Tick();
  link_.time += Seconds(10.0);
  Send(5, 50);
  Tick();
  const LogState state = *link_.Last(topics::kLogState);
  EXPECT_GT(state.missing, 0);
  EXPECT_EQ(Logged() + state.missing, sent_);
  EXPECT_THAT(app_->warnings().at("LOG_DROPPED").text,
              HasSubstr(std::to_string(state.missing) + " messages are missing in the log"));
  EXPECT_THAT(Text(), HasSubstr("\n%% " + std::to_string(state.missing) +
                                " messages are missing here: the disk did not take them\n"));
}

TEST_P(LogOnAFailingDisk, BeginsALogOnceTheDiskTakesOne) {
  disk_.Set(GetParam());
  app_.emplace(context_, LogApp::Params{});
  Send(7, 50);
  Tick();
  EXPECT_TRUE(app_->warnings().contains("LOG_FAILED"));
  disk_.Set(Fault::kNone);
  link_.time += Seconds(10.0);
  Send(5, 50);
  Tick();
  EXPECT_FALSE(app_->warnings().contains("LOG_FAILED"));
  EXPECT_EQ(link_.Last(topics::kLogState)->missing, 7);
  EXPECT_EQ(Logged(), 5);
  EXPECT_THAT(Text(), HasSubstr("%% 7 messages before this could not be logged\n"));
}

TEST_P(LogOnAFailingDisk, SaysSoFromItsThreadInACommunityToo) {
  context_.runs_live = true;
  LogApp::Params params;
  params.path = folder_.path().string();
  params.file = "L";
  params.has_time_stamp = false;
  params.summary_file = "";
  app_.emplace(context_, params);
  Send(1, 50);
  app_->Tick(link_.time);
  EXPECT_TRUE(link_.Last(topics::kLogState)->is_written) << "whatever a former life had said";
  disk_.Set(GetParam());
  const auto warns_within_ticks = [this](bool is_wanted) {
    for (int tick = 0; tick < 10'000'000; ++tick) {
      app_->Tick(link_.time);
      if (app_->warnings().contains("LOG_FAILED") == is_wanted) return true;
    }
    return false;
  };
  Send(1, 50);
  EXPECT_TRUE(warns_within_ticks(true));
  disk_.Set(Fault::kNone);
  Send(1, 50);
  EXPECT_TRUE(warns_within_ticks(false));
  app_->Finish(link_.time);
  app_.reset();
  std::ifstream in(folder_.path() / "L" / "L.alog");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(std::ranges::count(text, 'x'), 3 * 50) << "nothing was dropped";
}

std::string NameOfFault(const ::testing::TestParamInfo<Fault>& tested) {
  return tested.param == Fault::kFull      ? "Full"
         : tested.param == Fault::kFailing ? "Failing"
                                           : "ReadOnly";
}

TEST(LogAppPowerCut, FindsALogThatWasClosedAndWhereItIs) {
  const TemporaryFolder place(PlaceInMemory());
  const auto root = place.path() / "disk", left = place.path() / "left";
  std::filesystem::create_directory(root);
  TornDisk disk(root);
  TestLink link;
  AppContext context;
  context.name = "pLog";
  context.link = &link;
  context.runs_live = true;
  context.run_folder = root;
  context.disk = &disk;
  LogApp::Params params;
  params.file = "L";
  params.has_time_stamp = false;
  params.summary_file = (root / "last").string();
  {
    LogApp app(context, params);
    for (int i = 0; i < 20; ++i) {
      app.Deliver(std::make_shared<const Message>(Message{.name = "FRAME",
                                                          .value = Binary(100),
                                                          .time = link.time,
                                                          .source = "test",
                                                          .source_aux = "",
                                                          .community = ""}));
    }
    app.Finish(link.time);
  }
  Random random(1, "cuts");
  for (int cut = 0; cut < 20; ++cut) {
    disk.Cut(disk.calls(), random, left);
    AlogReader reader = *AlogReader::Open(left / "L" / "L.alog");
    int frames = 0;
    for (AlogEntry entry; reader.Next(entry);) {
      frames += ReadBlog(left / "L", *ParseBlogMarker(entry.value)) ? 1 : 0;
    }
    EXPECT_EQ(frames, 20);
    EXPECT_TRUE(std::filesystem::exists(left / "pLog.session"));
    EXPECT_TRUE(std::filesystem::exists(left / "last"));
  }
}

INSTANTIATE_TEST_SUITE_P(Faults, LogOnAFailingDisk,
                         testing::Values(Fault::kFull, Fault::kFailing, Fault::kReadOnly),
                         NameOfFault);

}  // namespace
}  // namespace limpet
