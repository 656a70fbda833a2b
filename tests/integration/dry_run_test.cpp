// SPDX-License-Identifier: MIT
// Missions flown before their launch: what is refused, and why; and that a vehicle comes home on
// what its battery holds.
#include "limpet/safety_trials/dry_run.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/check.hpp"
#include "apps/limpet/verbs/dry_run_check.hpp"
#include "limpet/runs/session_runner.hpp"
#include "tests/support/sound_flight.hpp"
#include "tests/support/temporary_folder.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(DryRun, SavesNoLogAndRendersNothing) {
  MissionFile mission = ParseMission(
      "ProcessConfig = ANTLER\n{\n  Run = pLog\n  Run = pNav\n}\n"
      "ProcessConfig = uSimCamera\n{\n}\nProcessConfig = uSimVehicle\n{\n}\n",
      "m.moos");
  mission = PreparedForDryRun(std::move(mission));
  ASSERT_EQ(mission.launches.size(), 1U);
  EXPECT_EQ(mission.launches.front().binary, "pNav");
  EXPECT_EQ(mission.Block("uSimCamera")->Find("camera")->value, "boxes");
}

TEST(DryRun, SaysInJsonWhatItSaysInWords) {
  DryFlight flight = SoundFlight();
  flight.tripped.push_back({.rule = "leak", .action = "abort", .phase = "DIVE", .after_s = 61.0});
  flight.tripped.push_back({.rule = "disk_low", .action = "warn", .phase = "DIVE"});
  DryRun run{.flights = {{.seed = 7, .flight = flight}, {.seed = 8, .flight = SoundFlight()}}};
  const nlohmann::ordered_json out = JsonOf(run);
  EXPECT_TRUE(out["is_refused"].get<bool>());
  EXPECT_EQ(run.ExitCode(), 3);
  const nlohmann::ordered_json& first = out["flights"][0];
  EXPECT_EQ(first["seed"], 7);
  EXPECT_EQ(first["rules"][0]["rule"], "leak");
  EXPECT_EQ(first["rules"][0]["after_s"], 61.0);
  EXPECT_EQ(first["objections"].size(), 1U);
  EXPECT_EQ(first["notes"].size(), 1U);
  EXPECT_EQ(first["energy"]["reserve_wh"], 60.0);
  EXPECT_TRUE(out["flights"][1]["objections"].empty());
  run.flights.erase(run.flights.begin());
  EXPECT_EQ(run.ExitCode(), 0);
}

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// What `limpet check --dry-run --json` prints of the basin's mission with an area of twice
/// `half_width` metres each way.
nlohmann::ordered_json CheckedBasin(const std::string& half_width, int expected_code) {
  const TemporaryFolder folder;
  const fs::path basin = fs::path(LIMPET_SOURCE_DIR) / "missions/basin";
  for (const char* name : {"mission.moos", "mission.bhv", "scenario.yaml"}) {
    std::ifstream in(basin / name);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    std::ofstream(folder.path() / name) << Replaced(
        Replaced(text, "_MIN -10", "_MIN -" + half_width), "_MAX 10", "_MAX " + half_width);
  }
  testing::internal::CaptureStdout();
  const int code = RunCheck(
      std::vector<std::string>{folder.path().string(), "--dry-run", "--json", "--seeds", "1"});
  const std::string printed = testing::internal::GetCapturedStdout();
  EXPECT_EQ(code, expected_code) << printed;
  return nlohmann::ordered_json::parse(printed);
}

TEST(DryRun, PrintsTheCheckAndItsFlightsAsOneObjectOfJson) {
  const auto out = CheckedBasin("7", 0);
  EXPECT_TRUE(out["syntax"].empty());
  EXPECT_EQ(out["dry_run"]["is_refused"], false);
  const auto& flights = out["dry_run"]["flights"];
  ASSERT_EQ(flights.size(), 2U);
  for (const auto& [flight, session] :
       {std::pair{flights[0], "discovery"}, {flights[1], "change"}}) {
    EXPECT_EQ(flight["session"], session);
    EXPECT_EQ(flight["seed"], 1);
    EXPECT_EQ(flight["ended"], "home");
    EXPECT_GT(flight["way_m"], 20.0);
  }
}

TEST(DryRun, FliesNoChangeSessionOfAMissionThatKeepsNothing) {
  const fs::path basin = fs::path(LIMPET_SOURCE_DIR) / "missions/basin";
  const TrialPlaces places{.mission_folder = basin, .scratch = {}};
  MissionFile mission = PreparedForDryRun(LoadMission(basin / "mission.moos"));
  EXPECT_THAT(DrySessions(mission, places), ElementsAre("discovery", "change"));
  std::erase_if(mission.launches,
                [](const LaunchEntry& launch) { return launch.binary == "pSession"; });
  EXPECT_THAT(DrySessions(mission, places), ElementsAre("discovery"));
}

TEST(DryRun, TheChangeSessionIsComparedWithWhatTheDiscoveryKept) {
  const TemporaryFolder folder;
  const fs::path basin = fs::path(LIMPET_SOURCE_DIR) / "missions/basin";
  MissionFile mission = PreparedForDryRun(LoadMission(basin / "mission.moos"));
  const TrialPlaces places{.mission_folder = basin, .scratch = folder.path()};
  EXPECT_THROW(static_cast<void>(FlyDry(mission, places, 3, "change")), ConfigError)
      << "there is no former session yet";
}

TEST(DryRun, FliesNothingWhereTheMissionCannotWork) {
  const auto out = CheckedBasin("4", 3);
  EXPECT_FALSE(out["geometry"].empty()) << "buoys lie outside";
  EXPECT_TRUE(out["dry_run"].is_null());
}

TEST(DryRun, IsRefusedForAMissionWithoutAVehicleToSimulate) {
  EXPECT_THROW(
      static_cast<void>(RunCheck(std::vector<std::string>{
          std::string(LIMPET_SOURCE_DIR) + "/missions/two_communities/shore.moos", "--dry-run"})),
      UsageError);
}

/// The basin with a small area in its middle and a battery of 12 Wh, most of it a reserve.
MissionFile SmallSurvey(const fs::path& folder) {
  std::ofstream(folder / "vehicle.yaml")
      << "based_on: feelhippo.yaml\nname: Small\nbattery: {capacity_wh: 12}\n";
  MissionFile mission =
      PreparedForDryRun(LoadMission(fs::path(LIMPET_SOURCE_DIR) / "missions/basin/mission.moos"));
  const std::vector<std::string> usual{"VehicleFile=" + (folder / "vehicle.yaml").string(),
                                       "pSurvey.area_north_min_m=-4",
                                       "pSurvey.area_north_max_m=4",
                                       "pSurvey.area_east_min_m=-4",
                                       "pSurvey.area_east_max_m=4",
                                       "pSurvey.align_s=20",
                                       "pSurvey.last_fix_s=5",
                                       "pSurvey.coverage_kind=seabed",
                                       "pSurvey.coverage_target=1",
                                       "pSurvey.energy_reserve_percent=60"};
  for (const std::string& setting : usual) {
    ApplySetting(mission, setting);
  }
  return mission;
}

TEST(DryRun, ComesHomeWithItsReserveOnABatteryThatIsTooSmall) {
  const TemporaryFolder folder;
  const MissionFile mission = SmallSurvey(folder.path());
  const DryFlight flight = FlyDry(
      mission,
      {.mission_folder = fs::path(LIMPET_SOURCE_DIR) / "missions/basin", .scratch = folder.path()},
      3);
  EXPECT_THAT(flight.Objections(), ElementsAre(HasSubstr("it ended `timeout`")))
      << "no rule trips: the helm itself turns home in time";
  EXPECT_LT(flight.home_error_m, 3.0);
  EXPECT_LT(flight.down_m, 0.5);
  EXPECT_GT(flight.energy->left_wh, 0.55 * 12.0);
}

}  // namespace
}  // namespace limpet
