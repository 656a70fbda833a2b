// SPDX-License-Identifier: MIT
// A vehicle that is put into the water far from its area: it goes there, surveys, and comes back.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/runs/session_runner.hpp"
#include "limpet/scoring/session_record.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

/// The basin with a small area in its middle and another start.
class FarStart {
 public:
  explicit FarStart(const std::string& start) {
    const fs::path basin = fs::path(LIMPET_SOURCE_DIR) / "missions" / "basin";
    fs::copy(basin, Mission(), fs::copy_options::recursive);
    std::ifstream in(basin / "scenario.yaml");
    std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    const std::size_t line = text.find("start:");
    text.replace(line, text.find('\n', line) - line, "start:   " + start);
    std::ofstream(Mission() / "scenario.yaml") << text;
    mission_ = LoadMission(basin / "mission.moos");
    for (const char* setting :
         {"uSimCamera.camera=boxes", "pSurvey.area_north_min_m=-4", "pSurvey.area_north_max_m=4",
          "pSurvey.area_east_min_m=-4", "pSurvey.area_east_max_m=4", "pSurvey.align_s=20",
          "pSurvey.last_fix_s=5", "pSurvey.coverage_kind=seabed", "pSurvey.coverage_target=0.6",
          "pSurvey.stall_s=60"}) {
      ApplySetting(mission_, setting);
    }
  }
  [[nodiscard]] fs::path Mission() const { return folder_.path() / "mission"; }

  SessionOutcome Fly(SessionRecord& record) {
    const SessionPlan plan{.session = "discovery",
                           .mission_folder = Mission(),
                           .run_folder = folder_.path() / "discovery",
                           .prior_folder = {},
                           .seed = 5};
    return RunSession(mission_, plan,
                      [&record](const Message& message) { record.Collect(message); });
  }

 private:
  TemporaryFolder folder_;
  MissionFile mission_;
};

void ExpectSurveyFrom(const std::string& start) {
  FarStart far(start);
  SessionRecord record("discovery");
  const SessionOutcome outcome = far.Fly(record);
  EXPECT_EQ(outcome.ended, "home") << outcome.cut.value_or("");
  ASSERT_FALSE(record.believed_coverage.empty());
  EXPECT_GE(record.believed_coverage.back().value.seabed, 0.6);
  ASSERT_FALSE(record.truth.empty());
  const std::size_t last = record.truth.size() - 1;
  EXPECT_LT(std::hypot(record.truth.north(last) - record.truth.north(0),
                       record.truth.east(last) - record.truth.east(0)),
            3.0);
  for (const WarningRecord& warning : record.warnings) {
    EXPECT_NE(warning.id, "OUTSIDE_REGION") << warning.text;
    EXPECT_NE(warning.id, "NO_OPTION") << warning.text;
  }
}

// The way there takes two minutes, twice what a stalled survey is given.
TEST(FarStart, SixtyMetresAwaySurveysAndReturns) {
  ExpectSurveyFrom("{north_m: -66, east_m: 12, heading_deg: 200}");
}

TEST(FarStart, InsideSurveysAndReturnsAsEver) {
  ExpectSurveyFrom("{north_m: 1, east_m: -2, heading_deg: 0}");
}

TEST(SessionLimit, FollowsTheMission) {
  MissionFile mission =
      LoadMission(fs::path(LIMPET_SOURCE_DIR) / "missions" / "basin" / "mission.moos");
  ApplySetting(mission, "pSurvey.max_time_s=40000");
  const Seconds longest = LongestSession(mission);
  EXPECT_GT(longest, Seconds(40000.0));
  ApplySetting(mission, "pSurvey.max_time_s=50000");
  EXPECT_NEAR((LongestSession(mission) - longest).value(), 10000.0, 1e-6);
}

TEST(SessionLimit, SaysWhereItCutASession) {
  const TemporaryFolder folder;
  const fs::path basin = fs::path(LIMPET_SOURCE_DIR) / "missions" / "basin";
  const SessionPlan plan{.session = "discovery",
                         .mission_folder = basin,
                         .run_folder = folder.path() / "discovery",
                         .prior_folder = {},
                         .seed = 5,
                         .longest = Seconds(30.0)};
  MissionFile mission = LoadMission(basin / "mission.moos");
  ApplySetting(mission, "uSimCamera.camera=boxes");
  SessionRecord record("discovery");
  const SessionOutcome outcome =
      RunSession(mission, plan, [&record](const Message& message) { record.Collect(message); });
  EXPECT_EQ(outcome.ended, "timeout");
  ASSERT_TRUE(outcome.cut);
  EXPECT_THAT(*outcome.cut,
              testing::HasSubstr("cut, as too long, after 30 s: phase ALIGN, north -"));
  record.AddCut(*outcome.cut, outcome.duration);
  EXPECT_EQ(record.warnings.back().id, "SESSION_CUT");
}

}  // namespace
}  // namespace limpet
