// SPDX-License-Identifier: MIT
#include "limpet/launch/launch_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/launch/launch_warnings.hpp"

namespace limpet {
namespace {

using ::testing::HasSubstr;
using ::testing::Optional;

const Seconds kStart(1000.0);

class LaunchReportTest : public ::testing::Test {
 protected:
  /// What PLAUNCH_WARNINGS is written as when a process is in that state.
  std::optional<std::string> Said(const char* state, const std::string& last_end,
                                  double elapsed = 0.0) {
    report_.Watch({{.name = "pNav", .state = state, .last_end = last_end}},
                  kStart + Seconds(elapsed));
    return report_.TakeWarnings(kStart + Seconds(elapsed));
  }
  LaunchReport report_{"alpha", 1.0, kStart};
};

TEST_F(LaunchReportTest, WarnsOfAProcessThatDoesNotRunUntilItDoes) {
  EXPECT_FALSE(Said("running", ""));
  EXPECT_EQ(Said("waiting", "was killed by signal 9"),
            "DOWN_pNav (alarm): pNav was killed by signal 9");
  EXPECT_EQ(Said("running", "was killed by signal 9"), "none");
  EXPECT_EQ(Said("missing", "no program pNav"), "DOWN_pNav (alarm): pNav: no program pNav");
}

TEST_F(LaunchReportTest, SaysWhenAProcessThatIsDownIsGivenUp) {
  static_cast<void>(Said("waiting", "ended with code 1"));
  EXPECT_EQ(Said("given_up", "ended with code 1", 5.0),
            "DOWN_pNav (alarm): pNav ended with code 1: given up");
}

TEST_F(LaunchReportTest, AnEndOfItsOwnIsNoTrouble) { EXPECT_FALSE(Said("ended", "ended")); }

TEST_F(LaunchReportTest, WarnsOfTheMissionAsLongAsThereIsSomethingToSay) {
  report_.SetWarning(warnings::kNotUnderWay, "SURVEY_PHASE IDLE", kStart);
  report_.SetWarning(warnings::kMissionLost, "", kStart);
  EXPECT_EQ(report_.TakeWarnings(kStart), "NOT_UNDER_WAY (alarm): SURVEY_PHASE IDLE");
  report_.SetWarning(warnings::kNotUnderWay, "", kStart);
  report_.SetWarning(warnings::kMissionLost, "pHelm is given up", kStart);
  EXPECT_EQ(report_.TakeWarnings(kStart), "MISSION_LOST (alarm): pHelm is given up");
}

TEST_F(LaunchReportTest, ShowsWarningsAndEventsToViewers) {
  static_cast<void>(Said("waiting", "was killed", 2.5));
  report_.AddEvent(events::kProcess, "pNav was killed", kStart + Seconds(2.5));
  report_.OnRequest("app=pLaunch,duration=3,key=a", kStart + Seconds(3.0));
  const auto cast = report_.Take({{.name = "pNav", .state = "waiting"}}, {}, kStart + Seconds(3.0));
  EXPECT_THAT(cast, Optional(HasSubstr("DOWN_pNav (alarm since [2.50]): pNav was killed")));
  EXPECT_THAT(cast, Optional(HasSubstr("[2.50]: PROCESS: pNav was killed")));
}

}  // namespace
}  // namespace limpet
