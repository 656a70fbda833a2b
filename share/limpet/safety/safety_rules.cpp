// SPDX-License-Identifier: MIT
// The table itself. Limits are such that no sound mission of ours comes near them; a mission whose
// vehicle or waters ask for others says so in the block of pSafety.
#include <algorithm>
#include <array>

#include "limpet/safety/safety_rule.hpp"
#include "limpet/topics/survey_phase.hpp"

namespace limpet {
namespace {

using enum SafetyAction;
using Actions = std::array<SafetyAction, kSafetyPhases>;
using Id = SafetyRuleId;
constexpr auto kBelow = SafetyRule::Side::kBelow;

constexpr std::array<std::string_view, kSafetyPhases> kSafetyPhaseNames{
    "idle", "align", "dive", "survey", "return", "ascend"};

/// In the order of SurveyPhase. On its way up to a fix the vehicle ascends; when all is done it is
/// as idle as before.
constexpr std::array<SafetyPhase, kSurveyPhaseNames.size()> kPhaseInSurvey{
    SafetyPhase::kIdle,   SafetyPhase::kAlign,  SafetyPhase::kDive,   SafetyPhase::kSurvey,
    SafetyPhase::kReturn, SafetyPhase::kAscend, SafetyPhase::kAscend, SafetyPhase::kIdle};

// Idle, align, dive, survey, return, ascend.
constexpr Actions kWarnAlways{kWarn, kWarn, kWarn, kWarn, kWarn, kWarn};
constexpr Actions kUpFromBelow{kNone, kWarn, kSurface, kSurface, kSurface, kWarn};
constexpr Actions kUpNearGround{kNone, kNone, kSurface, kSurface, kSurface, kNone};
constexpr Actions kSlowWithoutSonar{kNone, kWarn, kWarn, kDegrade, kDegrade, kNone};
constexpr Actions kHomeBeforeIt{kWarn, kReturn, kReturn, kReturn, kWarn, kWarn};

constexpr SafetyRule::Limit kIsSo{};

// clang-format off
constexpr std::array<SafetyRule, kSafetyRules> kTable{{
    {.id = Id::kLeak, .name = "leak", .meaning = "Water in the hull (LEAK).",
     .limit = kIsSo, .hold = Seconds(1.0), .clears_after = {},
     .actions = {kWarn, kAbort, kAbort, kAbort, kAbort, kAbort}},
    {.id = Id::kBatteryLow, .name = "battery_low", .meaning = "Charge of the battery (BATTERY).",
     .side = kBelow, .limit = {"battery_low_percent", "%", 25.0, 0.0, 100.0},
     .hold = Seconds(10.0), .hysteresis = 2.0, .clears_after = Seconds(60.0), .actions = kHomeBeforeIt},
    {.id = Id::kBatteryCritical, .name = "battery_critical", .meaning = "Charge of the battery that brings it up at once.",
     .side = kBelow, .limit = {"battery_critical_percent", "%", 10.0, 0.0, 100.0},
     .hold = Seconds(10.0), .hysteresis = 2.0, .clears_after = Seconds(60.0),
     .actions = {kWarn, kSurface, kSurface, kSurface, kSurface, kSurface}},
    {.id = Id::kGaugeOff, .name = "gauge_off",
     .meaning = "Charge that the gauge says above what the battery's voltage speaks for (ENERGY_STATE).",
     .limit = {"gauge_off_percent", "%", 20.0, 1.0, 100.0}, .hold = Seconds(20.0), .hysteresis = 2.0,
     .clears_after = Seconds(60.0), .actions = kHomeBeforeIt},
    {.id = Id::kEnergyHome, .name = "energy_home",
     .meaning = "Energy left beyond the way home and the reserve (ENERGY_STATE).",
     .side = kBelow, .limit = {"energy_spare_wh", "Wh", 0.0, 0.0, 1e5}, .hold = Seconds(5.0),
     .hysteresis = 1.0, .clears_after = Seconds(60.0), .actions = kHomeBeforeIt},
    {.id = Id::kDepthOverLimit, .name = "depth_over_limit",
     .meaning = "Depth, the greater of estimate and pressure sensor.",
     .limit = {"depth_limit_m", "m", 100.0, 0.5, 11000.0}, .hold = Seconds(2.0), .clears_after = {},
     .actions = {kNone, kSurface, kSurface, kSurface, kSurface, kSurface}},
    {.id = Id::kAltitudeLow, .name = "altitude_low", .meaning = "Altitude above the seabed.",
     .side = kBelow, .limit = {"altitude_limit_m", "m", 0.8, 0.0, 50.0}, .hold = Seconds(3.0),
     .clears_after = {}, .actions = kUpNearGround},
    {.id = Id::kOutsideRegion, .name = "outside_region",
     .meaning = "Way outside the operating region or into a keep-out zone (SURVEY_AREA), once it was inside.",
     .limit = {"region_limit_m", "m", 10.0, 0.0, 10000.0}, .hold = Seconds(5.0), .clears_after = {},
     .actions = {kNone, kNone, kNone, kReturn, kNone, kNone}},
    {.id = Id::kInsideZone, .name = "inside_zone",
     .meaning = "Way into a keep-out zone (SURVEY_AREA) as a share of half the zone's width there, which is that of the greatest "
                "circle inside it that holds the place: what `outside_region` does not see in a narrow zone.",
     .limit = {"zone_share_percent", "%", 50.0, 1.0, 100.0}, .hold = Seconds(1.0), .clears_after = {},
     .actions = {kNone, kNone, kNone, kReturn, kNone, kNone}},
    {.id = Id::kFarFromHome, .name = "far_from_home", .meaning = "Distance from SURVEY_HOME.",
     .limit = {"home_limit_m", "m", 3000.0, 1.0, 1e6}, .hold = Seconds(5.0), .clears_after = {},
     .actions = {kNone, kNone, kReturn, kReturn, kWarn, kWarn}},
    {.id = Id::kMissionTime, .name = "mission_time", .meaning = "Time under way.",
     .limit = {"mission_limit_s", "s", 14400.0, 10.0, 1e7}, .hold = Seconds(0.0), .clears_after = {},
     .actions = {kNone, kSurface, kSurface, kSurface, kSurface, kWarn}},
    {.id = Id::kNavigationSilent, .name = "navigation_silent",
     .meaning = "Time without a NAV_STATE that can be used; real time in a community.",
     .limit = {"navigation_silent_s", "s", 20.0, 1.0, 3600.0}, .hold = Seconds(0.0),
     .clears_after = Seconds(2.0), .actions = {kNone, kWarn, kSurface, kSurface, kSurface, kSurface}},
    {.id = Id::kSigmaHigh, .name = "sigma_high", .meaning = "1-sigma of the position, the worse axis: go slowly.",
     .limit = {"sigma_high_m", "m", 5.0, 0.1, 1000.0}, .hold = Seconds(5.0), .hysteresis = 0.5,
     .clears_after = Seconds(10.0), .actions = {kNone, kNone, kWarn, kDegrade, kDegrade, kWarn}},
    {.id = Id::kSigmaOverLimit, .name = "sigma_over_limit", .meaning = "1-sigma of the position, the worse axis.",
     .limit = {"sigma_limit_m", "m", 20.0, 0.1, 10000.0}, .hold = Seconds(5.0), .clears_after = {},
     .actions = kUpNearGround},
    {.id = Id::kDvlSilent, .name = "dvl_silent", .meaning = "Time without a velocity of the DVL that pNav takes: go slowly.",
     .limit = {"dvl_silent_s", "s", 30.0, 1.0, 3600.0}, .hold = Seconds(0.0), .clears_after = Seconds(5.0),
     .actions = {kNone, kNone, kDegrade, kDegrade, kDegrade, kNone}},
    {.id = Id::kDvlLost, .name = "dvl_lost",
     .meaning = "Time without a velocity of the DVL that pNav takes; until then the depth over the seabed last seen is kept "
                "(`memory_s` of BHV_HoldAltitude).",
     .limit = {"dvl_lost_s", "s", 90.0, 1.0, 36000.0}, .hold = Seconds(0.0), .clears_after = {},
     .actions = kUpNearGround},
    {.id = Id::kDvlOutliers, .name = "dvl_outliers",
     .meaning = "Share of the DVL's velocities of the last ten seconds that pNav refuses: go slowly.",
     .limit = {"dvl_outliers_percent", "%", 20.0, 1.0, 100.0}, .hold = Seconds(3.0), .hysteresis = 5.0,
     .clears_after = Seconds(10.0), .actions = {kNone, kNone, kDegrade, kDegrade, kDegrade, kNone}},
    {.id = Id::kDvlStuck, .name = "dvl_stuck", .meaning = "Time that the DVL has said the very same velocity.",
     .limit = {"dvl_stuck_s", "s", 5.0, 1.0, 3600.0}, .hold = Seconds(0.0), .clears_after = Seconds(30.0),
     .actions = kUpFromBelow},
    {.id = Id::kAltitudeStuck, .name = "altitude_stuck", .meaning = "Time that the DVL has said the very same altitude.",
     .limit = {"altitude_stuck_s", "s", 5.0, 1.0, 3600.0}, .hold = Seconds(0.0), .clears_after = Seconds(30.0),
     .actions = kUpFromBelow},
    {.id = Id::kDepthSilent, .name = "depth_silent", .meaning = "Time without DEPTH_SENSOR, once it has spoken.",
     .limit = {"depth_silent_s", "s", 15.0, 1.0, 3600.0}, .hold = Seconds(0.0), .clears_after = Seconds(5.0),
     .actions = {kNone, kWarn, kSurface, kSurface, kSurface, kWarn}},
    {.id = Id::kDepthStuck, .name = "depth_stuck", .meaning = "Time that DEPTH_SENSOR has said the very same.",
     .limit = {"depth_stuck_s", "s", 10.0, 1.0, 3600.0}, .hold = Seconds(0.0), .clears_after = Seconds(30.0),
     .actions = {kNone, kWarn, kSurface, kSurface, kSurface, kSurface}},
    {.id = Id::kImuOutliers, .name = "imu_outliers",
     .meaning = "Share of IMU_DATA of the last ten seconds that pNav refuses: go slowly.",
     .limit = {"imu_outliers_percent", "%", 5.0, 0.1, 100.0}, .hold = Seconds(3.0), .hysteresis = 2.0,
     .clears_after = Seconds(10.0), .actions = {kNone, kWarn, kDegrade, kDegrade, kDegrade, kWarn}},
    {.id = Id::kImuStuck, .name = "imu_stuck", .meaning = "Time that IMU_DATA has said the very same rates and forces.",
     .limit = {"imu_stuck_s", "s", 3.0, 0.5, 3600.0}, .hold = Seconds(0.0), .clears_after = Seconds(30.0),
     .actions = {kNone, kWarn, kSurface, kSurface, kSurface, kSurface}},
    {.id = Id::kSonarSilent, .name = "sonar_silent",
     .meaning = "Time without OBSTACLE_SONAR under way, also if it never spoke, of a vehicle whose file has one: go slowly.",
     .limit = {"sonar_silent_s", "s", 15.0, 1.0, 3600.0}, .hold = Seconds(0.0), .clears_after = Seconds(5.0),
     .actions = kSlowWithoutSonar},
    {.id = Id::kSonarStuck, .name = "sonar_stuck",
     .meaning = "Time that OBSTACLE_SONAR has said the very same echoes (pings without any are all alike): go slowly.",
     .limit = {"sonar_stuck_s", "s", 10.0, 1.0, 3600.0}, .hold = Seconds(0.0), .clears_after = Seconds(10.0),
     .actions = kSlowWithoutSonar},
    {.id = Id::kDepthAgainstAltitude, .name = "depth_against_altitude",
     .meaning = "Change of the seabed's depth (depth + altitude) within 10 s, beyond 0.6 m per metre of way.",
     .limit = {"seabed_step_m", "m", 1.5, 0.2, 100.0}, .hold = Seconds(4.0), .clears_after = {},
     .actions = kUpNearGround},
    {.id = Id::kGpsJump, .name = "gps_jump",
     .meaning = "Jump of a GPS fix from the last one beyond 2 m/s, after a dive from the estimate, and three sigma of both.",
     .limit = {"gps_jump_m", "m", 10.0, 1.0, 10000.0}, .hold = Seconds(0.0), .clears_after = Seconds(60.0),
     .actions = {kNone, kWarn, kNone, kNone, kNone, kWarn}},
    {.id = Id::kNoProgress, .name = "no_progress",
     .meaning = "What is wanted of speed less what is made good on the wanted course.",
     .limit = {"progress_lack_mps", "m/s", 0.3, 0.01, 10.0}, .hold = Seconds(30.0), .clears_after = {},
     .actions = {kNone, kNone, kNone, kSurface, kSurface, kNone}},
    {.id = Id::kNoDepthProgress, .name = "no_depth_progress",
     .meaning = "Time that another depth (DESIRED_DEPTH, off by more than 1 m) has been wanted of a vehicle that knows where it is "
                "and has come no nearer.",
     .limit = {"depth_lack_s", "s", 60.0, 1.0, 3600.0}, .hold = Seconds(0.0), .clears_after = Seconds(10.0),
     .actions = {kNone, kNone, kSurface, kSurface, kSurface, kWarn}},
    {.id = Id::kThrustersSaturated, .name = "thrusters_saturated",
     .meaning = "Time that a thruster has been asked for all it gives.",
     .limit = {"saturated_s", "s", 60.0, 1.0, 3600.0}, .hold = Seconds(0.0), .clears_after = Seconds(10.0),
     .actions = kWarnAlways},
    {.id = Id::kHelmSilent, .name = "helm_silent", .meaning = "Time without IVPHELM_STATE; real time in a community.",
     .limit = {"helm_silent_s", "s", 15.0, 1.0, 3600.0}, .hold = Seconds(0.0), .clears_after = Seconds(2.0),
     .actions = {kNone, kWarn, kSurface, kSurface, kSurface, kSurface}},
    {.id = Id::kHelmIdle, .name = "helm_idle",
     .meaning = "Time that the helm has stopped all (IVPHELM_ALLSTOP), but for an operator's override.",
     .limit = {"helm_idle_s", "s", 20.0, 1.0, 3600.0}, .hold = Seconds(0.0), .clears_after = Seconds(2.0),
     .actions = {kNone, kWarn, kSurface, kReturn, kSurface, kWarn}},
    {.id = Id::kBehaviorFailed, .name = "behavior_failed", .meaning = "A behavior failed within the last 10 s (BHV_ERROR).",
     .limit = kIsSo, .hold = Seconds(0.0), .clears_after = Seconds(60.0), .actions = kWarnAlways},
    {.id = Id::kPilotSilent, .name = "pilot_silent", .meaning = "Time without THRUSTER_COMMAND; real time in a community.",
     .limit = {"pilot_silent_s", "s", 15.0, 1.0, 3600.0}, .hold = Seconds(0.0), .clears_after = Seconds(2.0),
     .actions = {kNone, kWarn, kSurface, kSurface, kSurface, kSurface}},
    {.id = Id::kAppDown, .name = "app_down",
     .meaning = "Time that an app has not been running (PLAUNCH_STATUS); real time in a community.",
     .limit = {"app_down_s", "s", 60.0, 1.0, 36000.0}, .hold = Seconds(0.0), .clears_after = Seconds(2.0),
     .actions = {kWarn, kReturn, kReturn, kReturn, kWarn, kWarn}},
    {.id = Id::kDetectorSilent, .name = "detector_silent",
     .meaning = "Time below the surface without DETECTIONS, from the survey on or once there were some: wait for them; real time in a community.",
     .limit = {"detector_silent_s", "s", 20.0, 1.0, 3600.0}, .hold = Seconds(0.0), .clears_after = Seconds(2.0),
     .actions = {kNone, kNone, kNone, kHold, kNone, kNone}},
    {.id = Id::kDetectorLost, .name = "detector_lost",
     .meaning = "Time below the surface without DETECTIONS, from the survey on or once there were some; real time in a community.",
     .limit = {"detector_lost_s", "s", 90.0, 1.0, 36000.0}, .hold = Seconds(0.0), .clears_after = {},
     .actions = {kNone, kNone, kNone, kReturn, kNone, kNone}},
    {.id = Id::kDetectorStorm, .name = "detector_storm", .meaning = "Boxes in a frame, mean of about twenty frames.",
     .limit = {"detector_boxes", "boxes", 30.0, 1.0, 10000.0}, .hold = Seconds(5.0), .hysteresis = 1.0,
     .clears_after = Seconds(10.0), .actions = kWarnAlways},
    {.id = Id::kClockStepped, .name = "clock_stepped", .meaning = "The wall clock was set within the last 10 s (WALL_CLOCK).",
     .limit = kIsSo, .hold = Seconds(0.0), .clears_after = Seconds(60.0), .actions = kWarnAlways},
    {.id = Id::kDiskLow, .name = "disk_low", .meaning = "Room left for the log; embedded only as a fault.",
     .side = kBelow, .limit = {"disk_low_mib", "MiB", 500.0, 0.0, 1e9}, .hold = Seconds(0.0), .hysteresis = 50.0,
     .clears_after = Seconds(10.0), .actions = kWarnAlways},
    {.id = Id::kDiskFull, .name = "disk_full", .meaning = "Room left that ends the survey; embedded only as a fault.",
     .side = kBelow, .limit = {"disk_full_mib", "MiB", 50.0, 0.0, 1e9}, .hold = Seconds(0.0), .hysteresis = 10.0,
     .clears_after = Seconds(10.0), .actions = kHomeBeforeIt},
    {.id = Id::kLogFailed, .name = "log_failed", .meaning = "Time that the log has not been written (LOG_STATE).",
     .limit = {"log_failed_s", "s", 30.0, 1.0, 3600.0}, .hold = Seconds(0.0), .clears_after = Seconds(10.0),
     .actions = kHomeBeforeIt},
    {.id = Id::kLinkLost, .name = "link_lost", .meaning = "Time without SHORE_BEAT, once there was one.",
     .limit = {"link_lost_s", "s", 600.0, 1.0, 1e6}, .hold = Seconds(0.0), .clears_after = Seconds(10.0),
     .actions = {kWarn, kReturn, kReturn, kReturn, kWarn, kWarn}},
    {.id = Id::kPlannerSlow, .name = "planner_slow",
     .meaning = "Real time that the helm's last decision on where next took (HELM_PLAN_TIME); embedded only as a fault.",
     .limit = {"planner_slow_s", "s", 5.0, 0.01, 3600.0}, .hold = Seconds(0.0), .clears_after = Seconds(30.0),
     .actions = kWarnAlways},
    {.id = Id::kMemoryHigh, .name = "memory_high",
     .meaning = "Resident memory of all processes (PLAUNCH_MEMORY); embedded only as a fault.",
     .limit = {"memory_limit_mib", "MiB", 4096.0, 1.0, 1e7}, .hold = Seconds(15.0), .hysteresis = 100.0,
     .clears_after = Seconds(60.0), .actions = kHomeBeforeIt},
    {.id = Id::kProcessorHigh, .name = "processor_high",
     .meaning = "Share of a core that the busiest process takes, mean of 20 s (PLAUNCH_PROCESSOR): go slowly, a metre may take it "
                "longer; embedded only as a fault.",
     .limit = {"processor_limit_percent", "%", 90.0, 1.0, 10000.0}, .hold = Seconds(15.0), .hysteresis = 10.0,
     .clears_after = Seconds(60.0), .actions = {kWarn, kWarn, kWarn, kDegrade, kDegrade, kWarn}},
}};
// clang-format on

static_assert([] {
  for (std::size_t i = 0; i < kSafetyRules; ++i) {
    if (static_cast<std::size_t>(kTable[i].id) != i) return false;
  }
  return true;
}());

}  // namespace

std::string_view NameOf(SafetyPhase phase) {
  return kSafetyPhaseNames[static_cast<std::size_t>(phase)];
}

SafetyPhase SafetyPhaseOf(std::string_view survey_phase) {
  const auto phase = SurveyPhaseOf(survey_phase).value_or(SurveyPhase::kIdle);
  return kPhaseInSurvey[static_cast<std::size_t>(phase)];
}

std::span<const SafetyRule, kSafetyRules> SafetyRules() { return kTable; }

const SafetyRule& SafetyRuleOf(SafetyRuleId id) { return kTable[static_cast<std::size_t>(id)]; }

}  // namespace limpet
