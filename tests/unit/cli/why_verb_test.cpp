// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/command_line.hpp"
#include "limpet/topics/mission.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class WhyVerbTest : public ::testing::Test {
 protected:
  struct Decision {
    double time = 0.0;
    int path_id = 0;
  };
  /// A log that began at `start`, with a beam and a way home in every decision.
  void WriteLog(const std::string& name, double start, const std::vector<Decision>& decisions) {
    const fs::path file = folder_.path() / name;
    fs::create_directories(file.parent_path());
    std::ofstream log(file);
    log << "%% LOG FILE:       ./x.alog\n%% LOGSTART " << start << "\n";
    for (const Decision& decision : decisions) {
      HelmBids bids;
      bids.path_id = decision.path_id;
      bids.cause = "periodic";
      bids.options = {{.source = "beam",
                       .length = 10.0,
                       .total = 5.0,
                       .rate = 0.5,
                       .bids = {{"cover", 1.0, {.value = 5.0, .why = {{"useful", 9.0}}}}}},
                      {.source = "home",
                       .length = 10.0,
                       .total = -3.0,
                       .rate = -0.3,
                       .bids = {{"cover", 1.0, {.value = -3.0}}}}};
      log << decision.time << "  HELM_BIDS  pHelm  "
          << std::get<std::string>(TopicCodec<HelmBids>::Encode(bids)) << "\n";
    }
  }
  int Run(std::vector<std::string> words) {
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    words.insert(words.begin(), "why");
    const int code = RunCommandLine(words);
    out_ = ::testing::internal::GetCapturedStdout();
    err_ = ::testing::internal::GetCapturedStderr();
    return code;
  }
  [[nodiscard]] std::string At(const std::string& name) const {
    return (folder_.path() / name).string();
  }
  [[nodiscard]] nlohmann::json Json() const { return nlohmann::json::parse(out_); }
  TemporaryFolder folder_;
  std::string out_, err_;
};

TEST_F(WhyVerbTest, AnswersForOneMomentForTheLastAndForASpan) {
  WriteLog("a.alog", 1000.0, {{10.0, 1}, {26.0, 2}, {42.0, 3}});
  ASSERT_EQ(Run({At("a.alog"), "--at", "30", "--json"}), kOk) << err_;
  EXPECT_EQ(Json().at("path_id"), 2);
  ASSERT_EQ(Run({At("a.alog"), "--last", "--json"}), kOk);
  EXPECT_EQ(Json().at("path_id"), 3);
  ASSERT_EQ(Run({At("a.alog"), "--from", "20", "--to", "42", "--json"}), kOk);
  ASSERT_EQ(Json().size(), 2U);
  EXPECT_EQ(Json().at(0).at("path_id"), 2);
  ASSERT_EQ(Run({At("a.alog"), "--changes"}), kOk);
  EXPECT_EQ(std::ranges::count(out_, '\n'), 4);
}

TEST_F(WhyVerbTest, OfARunAnswersForTheSessionThatBeganLastOrTheOneAskedFor) {
  WriteLog("run/discovery/discovery.alog", 1000.0, {{10.0, 1}});
  WriteLog("run/change/change.alog", 5000.0, {{10.0, 7}});
  ASSERT_EQ(Run({At("run"), "--json"}), kOk) << err_;
  EXPECT_EQ(Json().at("session"), "change");
  EXPECT_EQ(Json().at("path_id"), 7);
  ASSERT_EQ(Run({At("run"), "--session", "discovery", "--json"}), kOk);
  EXPECT_EQ(Json().at("path_id"), 1);
  EXPECT_EQ(Run({At("run"), "--session", "discover"}), kUsage);
  EXPECT_THAT(
      err_, HasSubstr("no session `discover`; nearest: `discovery`; sessions: change, discovery"));
  EXPECT_EQ(Run({At("run"), "--session", "nix"}), kUsage);
  EXPECT_THAT(err_, HasSubstr("no session `nix`; sessions: change, discovery"));
}

TEST_F(WhyVerbTest, SaysWhenThereIsNoSuchDecision) {
  WriteLog("a.alog", 1000.0, {{10.0, 1}});
  EXPECT_EQ(Run({At("a.alog"), "--at", "3"}), kFailed);
  EXPECT_THAT(err_, HasSubstr("no decision yet at 3 s; the first was at 10.0 s"));
  EXPECT_EQ(Run({At("a.alog"), "--from", "11"}), kFailed);
  WriteLog("none.alog", 1000.0, {});
  EXPECT_EQ(Run({At("none.alog")}), kFailed);
  EXPECT_THAT(err_, HasSubstr("no HELM_BIDS"));
}

TEST_F(WhyVerbTest, RefusesWhatContradictsItself) {
  WriteLog("a.alog", 1000.0, {{10.0, 1}});
  EXPECT_EQ(Run({At("a.alog"), "--at", "3", "--changes"}), kUsage);
  EXPECT_EQ(Run({At("a.alog"), "--last", "--from", "3"}), kUsage);
  EXPECT_EQ(Run({At("a.alog"), "--from", "300", "--to", "200"}), kUsage);
  EXPECT_THAT(err_, HasSubstr("--from 300 is after --to 200"));
  EXPECT_EQ(Run({At("a.alog"), "--session", "discovery"}), kUsage);
  std::ofstream(folder_.path() / "mission.moos") << "ServerPort = 9000\n";
  EXPECT_EQ(Run({At("mission.moos"), "--at", "3"}), kUsage);
  EXPECT_THAT(err_, HasSubstr("a live community knows its last decision only"));
}

TEST_F(WhyVerbTest, LeavesOutWhatCannotBeReadAndSaysSo) {
  WriteLog("a.alog", 1000.0, {{10.0, 1}});
  std::ofstream(folder_.path() / "a.alog", std::ios::app) << "12.0  HELM_BIDS  pHelm  {broken\n";
  EXPECT_EQ(Run({At("a.alog")}), kOk);
  EXPECT_THAT(err_, HasSubstr("1 HELM_BIDS or HELM_MOTION cannot be read"));
}

TEST_F(WhyVerbTest, OfAVehicleWithoutASurveySaysWhoWantsWhichCourse) {
  std::ofstream log(At("alpha.alog"));
  log << "%% LOGSTART 1000\n";
  const auto say = [&log](double time, double course, double speed) {
    HelmMotion motion;
    motion.course_deg = course, motion.speed_mps = speed;
    motion.opinions.resize(2);
    motion.opinions[0].behavior = "waypt_survey", motion.opinions[0].variables = "course";
    motion.opinions[0].summit = course;
    motion.opinions[1].behavior = "op_region", motion.opinions[1].variables = "course+speed";
    log << time << "  HELM_MOTION  pHelm  "
        << std::get<std::string>(TopicCodec<HelmMotion>::Encode(motion)) << "\n";
  };
  say(10.0, 358.0, 2.0), say(11.0, 1.0, 2.0), say(12.0, 1.5, 2.0), say(13.0, 90.0, 2.0);
  log.close();
  ASSERT_EQ(Run({At("alpha.alog"), "--at", "12.5"}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("12.0 s: no behavior decides where next"));
  EXPECT_THAT(out_, HasSubstr("course 1.5 deg"));
  ASSERT_EQ(Run({At("alpha.alog"), "--json"}), 0) << err_;
  EXPECT_TRUE(Json().at("chosen").is_null());
  EXPECT_TRUE(Json().at("options").empty());
  EXPECT_EQ(Json().at("motion").at("course_deg"), 90.0);
  ASSERT_EQ(Run({At("alpha.alog"), "--changes"}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("waypt_survey: course 358 deg, op_region: course+speed"));
  EXPECT_EQ(std::ranges::count(out_, '\n'), 3) << out_;
  EXPECT_EQ(Run({At("alpha.alog"), "--at", "5"}), 1);
  EXPECT_THAT(err_, HasSubstr("says nothing yet at 5 s; first at 10.0 s"));
}

TEST_F(WhyVerbTest, SaysSinceWhenAndWhyTheHelmIsStopped) {
  WriteLog("a.alog", 1000.0, {{10.0, 1}, {60.0, 2}});
  std::ofstream(At("a.alog"), std::ios::app)
      << "61.0  IVPHELM_STATE  pHelm  PARK\n61.0  IVPHELM_ALLSTOP  pHelm  ManualOverride\n"
      << "70.0  IVPHELM_STATE  pHelm  DRIVE\n70.0  IVPHELM_ALLSTOP  pHelm  clear\n";
  ASSERT_EQ(Run({At("a.alog"), "--at", "65"}), kOk) << err_;
  EXPECT_THAT(out_, HasSubstr("stopped since 61.0 s: ManualOverride"));
  ASSERT_EQ(Run({At("a.alog"), "--at", "65", "--json"}), kOk) << err_;
  EXPECT_EQ(Json().at("motion").at("stopped"), "ManualOverride");
  EXPECT_TRUE(Json().at("motion").at("speed_mps").is_null());
  ASSERT_EQ(Run({At("a.alog"), "--changes"}), kOk) << err_;
  EXPECT_THAT(out_, HasSubstr("61.0     -  stopped: ManualOverride"));
  EXPECT_THAT(out_, HasSubstr("70.0     -  goes on after ManualOverride"));
  ASSERT_EQ(Run({At("a.alog"), "--from", "60.5", "--json"}), kOk) << err_;
  EXPECT_EQ(Json().size(), 2U);
}

}  // namespace
}  // namespace limpet
