// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/dry_run_check.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/scratch_folder.hpp"
#include "limpet/core/interrupt.hpp"
#include "limpet/runs/flown_mission.hpp"
#include "limpet/runs/session_runner.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

bool Launches(const MissionFile& mission, std::string_view app) {
  const std::vector<std::string> apps = EmbeddedApps(mission);
  return std::ranges::find(apps, app) != apps.end();
}

/// Refuses a mission that lacks one of the apps without which a flight says nothing of it.
void RequireApps(const MissionFile& mission) {
  for (const std::string_view needed :
       {"uSimVehicle", "uSimSensors", "uSimCamera", "pSurvey", "pHelm", "pSafety"}) {
    if (!Launches(mission, needed)) {
      throw UsageError(
          fmt::format("{}: launches no {}, which a dry run needs", mission.file, needed));
    }
  }
}

std::string EnergyText(const DryFlight& flight) {
  return flight.energy ? fmt::format(", {:.0f} Wh used, {:.0f} Wh left", flight.energy->used_wh,
                                     flight.energy->left_wh)
                       : "";
}

/// One line, also where several things are wrong.
std::string LineOf(const SeedFlight& flown) {
  const DryFlight& flight = flown.flight;
  const std::vector<std::string> objections = flight.Objections(), remarks = flight.Remarks();
  return fmt::format("seed {}, {}: {}, {:.0f} s, {:.0f} m{}{}{}", flown.seed, flight.session,
                     flight.ended, flight.duration_s, flight.way_m, EnergyText(flight),
                     objections.empty() ? "" : fmt::format(": {}", fmt::join(objections, "; ")),
                     remarks.empty() ? "" : fmt::format("; note: {}", fmt::join(remarks, "; ")));
}

nlohmann::ordered_json RuleJson(const TrippedRule& tripped) {
  return {{"rule", tripped.rule},       {"action", tripped.action},   {"phase", tripped.phase},
          {"after_s", tripped.after_s}, {"north_m", tripped.north_m}, {"east_m", tripped.east_m},
          {"down_m", tripped.down_m}};
}

/// Null without a battery.
nlohmann::ordered_json FlightEnergyJson(const std::optional<FlightEnergy>& energy) {
  if (!energy) return nullptr;
  return {{"used_wh", energy->used_wh},
          {"left_wh", energy->left_wh},
          {"reserve_wh", energy->reserve_wh},
          {"is_empty", energy->is_off}};
}

nlohmann::ordered_json FlightJson(const SeedFlight& flown) {
  const DryFlight& flight = flown.flight;
  nlohmann::ordered_json rules = nlohmann::ordered_json::array();
  for (const TrippedRule& tripped : flight.tripped) {
    rules.push_back(RuleJson(tripped));
  }
  return {{"seed", flown.seed},       {"session", flight.session},
          {"ended", flight.ended},    {"duration_s", flight.duration_s},
          {"way_m", flight.way_m},    {"home_error_m", flight.home_error_m},
          {"down_m", flight.down_m},  {"energy", FlightEnergyJson(flight.energy)},
          {"rules", rules},           {"objections", flight.Objections()},
          {"notes", flight.Remarks()}};
}

bool IsRefused(const SeedFlight& flown) { return !flown.flight.Objections().empty(); }

}  // namespace

int DryRun::refused() const { return static_cast<int>(std::ranges::count_if(flights, IsRefused)); }

int DryRun::ExitCode() const { return is_interrupted ? kFailed : refused() == 0 ? kOk : kRefused; }

DryRun FlyDryRun(const fs::path& path, const MissionChange& change, const DryRunSeeds& seeds,
                 const std::function<void(const SeedFlight&)>& told) {
  const fs::path file = FlownMissionAt(path);
  MissionFile read = LoadMission(file);
  if (change) change(read);
  RequireApps(read);
  const MissionFile mission = PreparedForDryRun(read);
  const ScratchFolder scratch("limpet_dry");
  const TrialPlaces places{.mission_folder = file.has_parent_path() ? file.parent_path() : ".",
                           .scratch = scratch.path()};
  DryRun run;
  for (int i = 0; i < seeds.count && !run.is_interrupted; ++i) {
    const std::uint64_t seed = seeds.first + static_cast<std::uint64_t>(i);
    for (const std::string& session : DrySessions(mission, places)) {
      SeedFlight flown{.seed = seed, .flight = FlyDry(mission, places, seed, session)};
      run.is_interrupted = interrupt_requested;
      if (run.is_interrupted) break;
      told(flown);
      run.flights.push_back(std::move(flown));
      if (IsRefused(run.flights.back())) break;  // what it saved is no session to come back to
    }
  }
  return run;
}

void PrintFlight(const SeedFlight& flown) {
  fmt::print("{}\n", LineOf(flown));
  std::fflush(stdout);
}

void PrintVerdict(const DryRun& run) {
  if (run.is_interrupted) return;
  const std::size_t count = run.flights.size();
  const auto warned = std::ranges::count_if(
      run.flights, [](const SeedFlight& flown) { return !flown.flight.Remarks().empty(); });
  const std::string rules =
      warned == 0 ? "no rule tripped" : fmt::format("in {} of them a rule warned", warned);
  fmt::print("{}\n",
             run.refused() == 0
                 ? fmt::format("dry run: {} of {} flights came home, {}", count, count, rules)
                 : fmt::format("dry run: refused, by {} of {} flights", run.refused(), count));
}

nlohmann::ordered_json JsonOf(const DryRun& run) {
  nlohmann::ordered_json flights = nlohmann::ordered_json::array();
  for (const SeedFlight& flown : run.flights) {
    flights.push_back(FlightJson(flown));
  }
  return {{"is_refused", run.refused() > 0},
          {"is_interrupted", run.is_interrupted},
          {"flights", flights}};
}

}  // namespace limpet
