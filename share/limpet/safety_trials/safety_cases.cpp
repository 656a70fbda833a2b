// SPDX-License-Identifier: MIT
// What `limpet safety test` flies: at least one case for each rule that simulation can provoke.
#include <array>

#include "limpet/safety_trials/safety_trial.hpp"

namespace limpet {
namespace {

using Id = SafetyRuleId;

constexpr SafetyPhase kFromAlign = SafetyPhase::kAlign, kFromDive = SafetyPhase::kDive,
                      kFromSurvey = SafetyPhase::kSurvey, kToDive = SafetyPhase::kDive,
                      kToSurvey = SafetyPhase::kSurvey, kToReturn = SafetyPhase::kReturn,
                      kToAscend = SafetyPhase::kAscend;

constexpr TrialLimit Given(double limit) {
  return {.kind = TrialLimit::Kind::kGiven, .value = limit};
}
constexpr TrialLimit BeyondCalm(double by) {
  return {.kind = TrialLimit::Kind::kBeyondCalm, .value = by};
}
constexpr TrialLimit AtBegin() { return {.kind = TrialLimit::Kind::kAtBegin}; }

// clang-format off
constexpr std::array<SafetyCase, 51> kCases{{
    {"leak", "what: leak", Id::kLeak, Seconds(3.0)},
    {"battery low", "what: battery", Id::kBatteryLow, Seconds(12.0)},
    {"battery critical", "what: battery, size: 0.05", Id::kBatteryCritical, Seconds(12.0)},
    {"energy short", "what: battery, size: 0.14", Id::kEnergyHome, Seconds(8.0)},
    {"cells lost", "what: cells_lost", Id::kGaugeOff, Seconds(50.0)},
    {"DVL silent", "what: dvl_silent", Id::kDvlSilent, Seconds(31.0)},
    {"DVL without lock", "what: dvl_no_lock", Id::kDvlSilent, Seconds(31.0)},
    {"DVL flipped", "what: dvl_flipped", Id::kDvlSilent, Seconds(50.0), kFromSurvey},
    // Of a vehicle that has not moved yet nothing tells it apart: it shows where a survey gets nowhere.
    {"DVL flipped early", "what: dvl_flipped", Id::kNoProgress, Seconds(75.0), kFromAlign, kToDive},
    {"DVL outliers", "what: dvl_outliers", Id::kDvlOutliers, Seconds(12.0), kFromDive},
    {"DVL stuck", "what: dvl_stuck", Id::kDvlStuck, Seconds(6.0)},
    {"altitude stuck", "what: altitude_stuck", Id::kAltitudeStuck, Seconds(6.0)},
    {"altitude off", "what: altitude_biased", Id::kDepthAgainstAltitude, Seconds(6.0), kFromDive},
    {"depth silent", "what: depth_silent", Id::kDepthSilent, Seconds(16.0)},
    {"depth stuck", "what: depth_stuck", Id::kDepthStuck, Seconds(11.0)},
    {"IMU stuck", "what: imu_stuck", Id::kImuStuck, Seconds(4.0)},
    {"IMU outliers", "what: imu_outliers", Id::kImuOutliers, Seconds(8.0)},
    {"sonar silent", "what: sonar_silent", Id::kSonarSilent, Seconds(16.0), kFromAlign, kToReturn},
    {"sonar stuck", "what: sonar_stuck", Id::kSonarStuck, Seconds(11.0), kFromAlign, kToSurvey, {}, "", TrialProp::kObstacle},
    {"IMU silent", "what: imu_silent", Id::kNavigationSilent, Seconds(27.0)},
    {"GPS jump", "what: gps_jump", Id::kGpsJump, Seconds(15.0)},
    {"thrusters dead", "what: thrusters_weak, size: 0", Id::kNoProgress, Seconds(60.0), kFromSurvey, kToReturn},
    {"never dives", "what: thrusters_weak, size: 0", Id::kNoDepthProgress, Seconds(75.0), kFromAlign, kToDive},
    {"camera silent", "what: camera_silent", Id::kDetectorSilent, Seconds(21.0)},
    {"helm hangs", "what: app_hangs, app: pHelm", Id::kHelmSilent, Seconds(16.0)},
    {"pilot hangs", "what: app_hangs, app: pPilot", Id::kPilotSilent, Seconds(16.0)},
    {"navigation hangs", "what: app_hangs, app: pNav", Id::kNavigationSilent, Seconds(21.0)},
    {"disk full", "what: disk_full", Id::kDiskFull, Seconds(11.0)},
    {"disk failing", "what: disk_failing", Id::kLogFailed, Seconds(33.0)},
    {"false boxes", "what: false_boxes, for_s: 15", Id::kDetectorStorm, Seconds(8.0), kFromDive},
    {"link lost", "what: link_lost", Id::kLinkLost, Seconds(21.0), kFromAlign, kToAscend, Given(20.0)},
    {"depth over limit", "what: depth_biased, size: 200", Id::kDepthOverLimit, Seconds(4.0)},
    {"altitude low", "what: altitude_biased, size: -2.4", Id::kAltitudeLow, Seconds(6.0), kFromSurvey, kToReturn, BeyondCalm(0.3)},
    {"ground near", "", Id::kAltitudeLow, Seconds(30.0), kFromDive, kToDive, BeyondCalm(-1.0)},
    {"swept out", "what: current", Id::kOutsideRegion, Seconds(40.0), kFromSurvey, kToSurvey, BeyondCalm(2.0)},
    {"swept into zone", "what: current", Id::kInsideZone, Seconds(45.0), kFromSurvey, kToSurvey, {}, "outside_region", TrialProp::kZone},
    {"swept away", "what: current", Id::kFarFromHome, Seconds(45.0), kFromDive, kToAscend, BeyondCalm(5.0), "outside_region"},
    {"time over", "", Id::kMissionTime, Seconds(11.0), kFromAlign, kToAscend, AtBegin()},
    {"sigma high", "what: dvl_silent", Id::kSigmaHigh, Seconds(50.0), kFromAlign, kToAscend, BeyondCalm(0.1), "dvl_silent"},
    {"sigma over limit", "what: dvl_silent", Id::kSigmaOverLimit, Seconds(50.0), kFromAlign, kToAscend, BeyondCalm(0.1)},
    {"DVL lost", "what: dvl_silent", Id::kDvlLost, Seconds(33.0), kFromAlign, kToAscend, Given(32.0)},
    {"thrusters weak", "what: thrusters_weak, size: 0.02", Id::kThrustersSaturated, Seconds(20.0), kFromDive, kToReturn, Given(10.0)},
    {"behavior fails", "", Id::kBehaviorFailed, Seconds(5.0), kFromAlign, kToAscend, {}, "", TrialProp::kFailingBehavior},
    {"helm idle", "", Id::kHelmIdle, Seconds(21.0), kFromAlign, kToAscend, {}, "", TrialProp::kFailingBehavior},
    {"app down", "what: app_down, app: pMap", Id::kAppDown, Seconds(31.0), kFromAlign, kToAscend, Given(30.0)},
    {"camera lost", "what: camera_silent", Id::kDetectorLost, Seconds(31.0), kFromAlign, kToAscend, Given(30.0)},
    {"disk low", "what: disk_low", Id::kDiskLow, Seconds(11.0)},
    {"planner slow", "what: slow_planner", Id::kPlannerSlow, Seconds(10.0), kFromSurvey, kToReturn, {}, "", TrialProp::kNone, Seconds(0.0)},
    {"memory high", "what: memory", Id::kMemoryHigh, Seconds(16.0)},
    {"processor high", "what: processor", Id::kProcessorHigh, Seconds(16.0)},
    {"clock stepped", "what: clock_stepped", Id::kClockStepped, Seconds(1.0)},
}};
// clang-format on

}  // namespace

std::span<const SafetyCase> SafetyCases() { return kCases; }

}  // namespace limpet
