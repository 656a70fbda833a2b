// SPDX-License-Identifier: MIT
// Faults, flown: what the safety rules do about them, and where that leaves the vehicle. All of
// them in every phase: `limpet safety test missions/basin`.
#include "limpet/safety_trials/safety_trial.hpp"

#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "limpet/runs/session_runner.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

struct FlownCase {
  const char* name;  ///< of the case
  SafetyPhase phase;
  SafetyAction action;
  const char* ended;
};

class FlownFault : public testing::TestWithParam<FlownCase> {};

TEST_P(FlownFault, IsAnsweredInTimeAndTheVehicleComesUp) {
  const std::filesystem::path folder =
      std::filesystem::path(LIMPET_SOURCE_DIR) / "missions" / "basin";
  const TemporaryFolder scratch;
  const auto tested =
      std::ranges::find(SafetyCases(), std::string_view(GetParam().name), &SafetyCase::name);
  ASSERT_NE(tested, SafetyCases().end());
  const SafetyTrialResult result = FlySafetyTrial(
      ShortenedForTrials(LoadMission(folder / "mission.moos")),
      {.mission_folder = folder, .scratch = scratch.path()}, *tested, GetParam().phase, 7);
  EXPECT_EQ(result.complaint, "");
  EXPECT_EQ(result.instead, "") << "its own rule answers";
  EXPECT_EQ(NameOf(result.action), NameOf(GetParam().action));
  EXPECT_EQ(result.ended, GetParam().ended);
}

INSTANTIATE_TEST_SUITE_P(
    OfTheBasin, FlownFault,
    testing::Values(
        FlownCase{"leak", SafetyPhase::kDive, SafetyAction::kAbort, "aborted"},
        FlownCase{"battery low", SafetyPhase::kSurvey, SafetyAction::kReturn, "aborted"},
        FlownCase{"disk failing", SafetyPhase::kSurvey, SafetyAction::kReturn, "aborted"},
        FlownCase{"helm hangs", SafetyPhase::kReturn, SafetyAction::kSurface, "aborted"},
        FlownCase{"false boxes", SafetyPhase::kSurvey, SafetyAction::kWarn, "timeout"},
        FlownCase{"link lost", SafetyPhase::kDive, SafetyAction::kReturn, "aborted"},
        FlownCase{"clock stepped", SafetyPhase::kReturn, SafetyAction::kWarn, "timeout"},
        FlownCase{"app down", SafetyPhase::kSurvey, SafetyAction::kReturn, "aborted"},
        FlownCase{"planner slow", SafetyPhase::kSurvey, SafetyAction::kWarn, "timeout"},
        FlownCase{"memory high", SafetyPhase::kDive, SafetyAction::kReturn, "aborted"},
        FlownCase{"disk low", SafetyPhase::kReturn, SafetyAction::kWarn, "timeout"},
        FlownCase{"behavior fails", SafetyPhase::kDive, SafetyAction::kWarn, "aborted"},
        FlownCase{"time over", SafetyPhase::kSurvey, SafetyAction::kSurface, "aborted"},
        FlownCase{"camera silent", SafetyPhase::kSurvey, SafetyAction::kHold, "timeout"},
        FlownCase{"camera silent", SafetyPhase::kAlign, SafetyAction::kHold, "timeout"},
        FlownCase{"camera lost", SafetyPhase::kAlign, SafetyAction::kReturn, "aborted"},
        FlownCase{"sonar silent", SafetyPhase::kAlign, SafetyAction::kWarn, "timeout"},
        FlownCase{"sonar silent", SafetyPhase::kSurvey, SafetyAction::kDegrade, "timeout"},
        FlownCase{"sonar stuck", SafetyPhase::kAlign, SafetyAction::kWarn, "timeout"},
        FlownCase{"sonar stuck", SafetyPhase::kSurvey, SafetyAction::kDegrade, "timeout"},
        FlownCase{"processor high", SafetyPhase::kSurvey, SafetyAction::kDegrade, "timeout"},
        FlownCase{"swept into zone", SafetyPhase::kSurvey, SafetyAction::kReturn, "aborted"}));

TEST(FlownFaults, ASurveyWithoutItsDvlIsBroughtUpByTheRuleForThatWhenItSays) {
  const std::filesystem::path folder =
      std::filesystem::path(LIMPET_SOURCE_DIR) / "missions" / "basin";
  const TemporaryFolder scratch;
  MissionFile mission = ShortenedForTrials(LoadMission(folder / "mission.moos"));
  ApplySetting(mission, "pSurvey.max_time_s=600");
  const SafetyCase lost{.name = "DVL lost for good",
                        .fault = "what: dvl_silent",
                        .rule = SafetyRuleId::kDvlLost,
                        .answer = Seconds(91.0)};
  const SafetyTrialResult result =
      FlySafetyTrial(mission, {.mission_folder = folder, .scratch = scratch.path()}, lost,
                     SafetyPhase::kSurvey, 7);
  EXPECT_EQ(result.complaint, "");
  EXPECT_EQ(result.instead, "") << "helm_idle does not end it before";
  EXPECT_EQ(NameOf(result.action), "surface");
  EXPECT_NEAR(result.after_s, 90.0, 1.0) << "dvl_lost_s";
  EXPECT_EQ(result.ended, "aborted");
}

TEST(FlownFaults, ARuleThatTripsBeforeTheFaultBeginsIsComplainedOf) {
  const std::filesystem::path folder =
      std::filesystem::path(LIMPET_SOURCE_DIR) / "missions" / "basin";
  const TemporaryFolder scratch;
  const SafetyCase hasty{.name = "hasty",
                         .fault = "what: gps_silent",
                         .rule = SafetyRuleId::kDepthOverLimit,
                         .answer = Seconds(5.0),
                         .limit = {.kind = TrialLimit::Kind::kGiven, .value = 1.0}};
  const SafetyTrialResult result = FlySafetyTrial(
      ShortenedForTrials(LoadMission(folder / "mission.moos")),
      {.mission_folder = folder, .scratch = scratch.path()}, hasty, SafetyPhase::kSurvey, 7);
  EXPECT_EQ(result.complaint, "surface before the fault began");
}

}  // namespace
}  // namespace limpet
