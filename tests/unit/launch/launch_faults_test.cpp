// SPDX-License-Identifier: MIT
// Faults of a scenario that no app of it makes, in a live mission: real processes under pLaunch.
#include "limpet/launch/launch_faults.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/topics/wall_clock.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/launch/live_mission.hpp"

namespace limpet {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

bool IsIn(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(LaunchFaults, OfProcessesAreMadeOfTheRealOnes) {
  LiveMission mission;
  mission.AppendToScenario(
      "faults:\n"
      "  - {what: app_down, app: pNav, when: SURVEY_PHASE = DIVE, at_s: 1, for_s: 6}\n"
      "  - {what: app_hangs, app: pHelm, when: SURVEY_PHASE = DIVE, at_s: 10, for_s: 2.5}\n");
  mission.Launch();
  ASSERT_TRUE(mission.AwaitDive()) << mission.Said();
  ASSERT_TRUE(mission.Await([&] {
    return IsIn(mission.Latest("PLAUNCH_STATUS"), "app=pNav,state=waiting");
  })) << mission.Said();
  const Seconds down = mission.Now();
  EXPECT_EQ(mission.PidOf("pNav"), 0);
  ASSERT_TRUE(mission.Await([&] {
    return IsIn(mission.Latest("PLAUNCH_STATUS"), "app=pNav,state=running,restarts=1");
  })) << mission.Said();
  EXPECT_GT(mission.Now() - down, Seconds(4.0)) << "kept down, not only killed";
  ASSERT_TRUE(mission.Await([&] {
    return IsIn(mission.Said(), "pHelm hangs: no sign of life for");
  })) << mission.Said();
  ASSERT_TRUE(mission.Await([&] {
    return IsIn(mission.Latest("PLAUNCH_STATUS"), "app=pHelm,state=running,restarts=1");
  })) << mission.Said();
}

TEST(LaunchFaults, OfDiskAndClockAndMeasuresReachTheProcesses) {
  LiveMission mission;
  mission.AppendToScenario(
      "faults:\n"
      "  - {what: clock_stepped, size: 3600, at_s: 2}\n"
      "  - {what: disk_full, at_s: 2}\n"
      "  - {what: memory, size: 8000, at_s: 2}\n"
      "  - {what: processor, size: 150, at_s: 2}\n");
  mission.Launch();
  ASSERT_TRUE(mission.Await([&] {
    const auto clock = DecodeRecord<WallClock>(mission.Latest("WALL_CLOCK"));
    return clock && clock->steps == 1 && clock->ahead > 3590.0;
  })) << mission.Latest("WALL_CLOCK");
  ASSERT_TRUE(mission.Await([&] { return mission.Latest("PLAUNCH_MEMORY") == "8000"; }));
  ASSERT_TRUE(mission.Await([&] {
    return IsIn(mission.Latest("PLAUNCH_PROCESSOR"), "percent=150");
  })) << mission.Latest("PLAUNCH_PROCESSOR");
  ASSERT_TRUE(mission.Await([&] {
    return IsIn(mission.Latest("PSURVEY_WARNINGS"), "STATE_NOT_KEPT");
  })) << mission.Latest("PSURVEY_WARNINGS");
}

LaunchPlan PlanWith(const TemporaryFolder& folder, const std::vector<std::string>& apps) {
  std::ofstream(folder.path() / "scenario.yaml")
      << "faults: [{what: app_down, app: pNav, at_s: 1}, {what: dvl_stuck}]\n";
  LaunchPlan plan;
  plan.mission_file = folder.path() / "mission.moos";
  for (const std::string& app : apps) {
    plan.items.push_back({.name = app, .program = "/usr/bin/" + app, .args = {}});
  }
  return plan;
}

TEST(LaunchFaults, AreNoneWhereNoVehicleIsSimulated) {
  const TemporaryFolder folder;
  EXPECT_TRUE(LaunchFaults(PlanWith(folder, {"pNav", "iVehicle"})).are_none());
  EXPECT_FALSE(LaunchFaults(PlanWith(folder, {"pNav", "uSimVehicle"})).are_none());
}

TEST(LaunchFaults, AreRefusedForAnAppThatIsNotLaunched) {
  const TemporaryFolder folder;
  try {
    const LaunchFaults faults(PlanWith(folder, {"pNavv", "uSimVehicle"}));
    FAIL() << "who is to be down?";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("scenario.yaml"), HasSubstr("pNavv")));
  }
}

}  // namespace
}  // namespace limpet
