// SPDX-License-Identifier: MIT
// Missions that safety rules, or the battery, would end before they have done what they are for.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/mission_copy.hpp"

namespace limpet {
namespace {

using testing::HasSubstr;

class CheckSafetyRules : public ::testing::TestWithParam<Slip> {};

TEST_P(CheckSafetyRules, SaysWhatIsWrong) { ExpectSaid(GetParam()); }

/// A line of the mission's own in the block of pSafety.
std::vector<Edit> Limit(const std::string& line) {
  return {{PlugOf("pSafety"), "  AppTick = 5\n", "  AppTick = 5\n  " + line + "\n"}};
}

std::vector<Edit> WithoutDepthRule() {
  return {{PlugOf("pSafety"), "  AppTick = 5\n",
           "  AppTick = 5\n  depth_limit_m = 3\n  off = depth_over_limit\n"}};
}

INSTANTIATE_TEST_SUITE_P(
    Limits, CheckSafetyRules,
    ::testing::Values(
        Slip{"ADepthLimitAboveTheSurvey",
             Limit("depth_limit_m = 3"),
             3,
             {"plug_pSafety.moos:5: depth_limit_m: `3`: rule depth_over_limit would bring the "
              "vehicle "
              "up from its survey, which goes as deep as 3.7 m; allowed: more than that"}},
        Slip{"ADepthLimitThatIsOff",
             WithoutDepthRule(),
             0,
             {"note: off: this mission does without rule depth_over_limit"}},
        Slip{"AnAltitudeLimitAboveTheSurvey",
             Limit("altitude_limit_m = 3.8"),
             3,
             {"`3.8`: rule altitude_low would bring the vehicle up from its survey, flown down to "
              "3.7 m (pSurvey altitude_m = 4"}},
        Slip{
            "ATimeLimitBelowTheSurveys",
            Limit("mission_limit_s = 600"),
            3,
            {"`600`: rule mission_time would bring the vehicle up before it may go home by pSurvey "
             "max_time_s = 5400"}},
        Slip{"AHomeLimitInsideTheArea",
             Limit("home_limit_m = 20"),
             3,
             {"`20`: rule far_from_home would end the survey: the area reaches as far as 43 m"}},
        Slip{"LimitsTheWrongWayRound",
             Limit("battery_critical_percent = 40"),
             3,
             {"battery_critical_percent = 40", "would trip before pSafety battery_low_percent"}},
        Slip{
            "ADvlThatIsMissedLongerThanItsSeabedIsRemembered",
            Limit("dvl_lost_s = 300"),
            0,
            {"plug_pSafety.moos:5: note: dvl_lost_s: a survey without its DVL has no depth to keep "
             "after altitude memory_s = 120",
             "before rule dvl_lost acts by pSafety dvl_lost_s = 300"}},
        Slip{"ALimitOutOfRange",
             Limit("depth_limit_m = -1"),
             2,
             {"depth_limit_m: `-1` is not allowed; allowed: 0.5 to 11000"}},
        Slip{"ARuleThatDoesNotExist",
             Limit("off = leek"),
             2,
             {"no safety rule `leek`; nearest known: `leak`"}}),
    [](const auto& slip) { return slip.param.name; });

class CheckEnergy : public ::testing::TestWithParam<Slip> {};

TEST_P(CheckEnergy, SaysWhatIsWrong) { ExpectSaid(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Batteries, CheckEnergy,
    ::testing::Values(
        Slip{"ABatteryThatLasts", {}, 0, {"energy: the survey takes about 37 Wh, ", "no problems"}},
        Slip{"ABatteryThatDoesNotLast",
             Vehicle("battery: {capacity_wh: 30}"),
             3,
             {"vehicle.yaml:3: battery: the survey takes about 37 Wh, ", "the battery holds 30 Wh",
              "allowed: 42 Wh or more"}},
        Slip{"ABatteryThatIsTight",
             Vehicle("battery: {capacity_wh: 50}"),
             0,
             {"note: battery: is tight: the survey takes about 37 Wh"}},
        Slip{
            "ABatteryThatIsNotCharged",
            {{"scenario.yaml", "seabed:", "errors: {battery: {charge: 0.2}}\nseabed:"}},
            3,
            {"scenario.yaml:", "battery: the survey takes about 37 Wh", "the battery holds 96 Wh"}},
        Slip{"ABatteryThatTheSafetyRuleTakesForLow",
             {{"scenario.yaml", "seabed:", "errors: {battery: {charge: 0.3}}\nseabed:"}},
             3,
             {"battery_low_percent: `25`: rule battery_low would end the survey: 24 % are left"}},
        Slip{"AReserveThatIsAllOfIt",
             {{PlugOf("pSurvey"), "ProcessConfig = pSurvey\n{\n",
               "ProcessConfig = pSurvey\n{\n  energy_reserve_percent = 95\n"}},
             2,
             {"energy_reserve_percent: `95` is not allowed; allowed: 0 to 90"}}),
    [](const auto& slip) { return slip.param.name; });

TEST(CheckVerbOfEnergy, HasItInJson) {
  const MissionCopy mission;
  const Checked checked = Check({mission.path().string(), "--json"});
  EXPECT_THAT(checked.text, HasSubstr("\"needed_wh\": 3"));
}

}  // namespace
}  // namespace limpet
