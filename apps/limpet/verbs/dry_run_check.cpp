// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/dry_run_check.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/limpet/cli.hpp"
#include "apps/limpet/verbs/scratch_folder.hpp"
#include "limpet/core/interrupt.hpp"
#include "limpet/runs/session_runner.hpp"
#include "limpet/safety_trials/dry_run.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

/// Without these a flight says nothing of the mission.
void RequireApps(const MissionFile& mission) {
  const std::vector<std::string> apps = EmbeddedApps(mission);
  for (const std::string_view needed :
       {"uSimVehicle", "uSimSensors", "uSimCamera", "pSurvey", "pHelm", "pSafety"}) {
    if (std::ranges::find(apps, needed) == apps.end()) {
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
std::string LineOf(std::uint64_t seed, const DryFlight& flight) {
  const std::vector<std::string> objections = flight.Objections();
  return fmt::format("seed {}: {}, {:.0f} s, {:.0f} m{}{}", seed, flight.ended, flight.duration_s,
                     flight.way_m, EnergyText(flight),
                     objections.empty() ? "" : fmt::format(": {}", fmt::join(objections, "; ")));
}

}  // namespace

int CheckByDryRun(const fs::path& path, const DryRunSeeds& seeds) {
  const fs::path file = MissionFileAt(path);
  const MissionFile read = LoadMission(file);
  RequireApps(read);
  const MissionFile mission = PreparedForDryRun(read);
  const ScratchFolder scratch("limpet_dry");
  const TrialPlaces places{.mission_folder = file.has_parent_path() ? file.parent_path() : ".",
                           .scratch = scratch.path()};
  int refused = 0;
  for (int i = 0; i < seeds.count; ++i) {
    const std::uint64_t seed = seeds.first + static_cast<std::uint64_t>(i);
    const DryFlight flight = FlyDry(mission, places, seed);
    if (interrupt_requested) return kFailed;
    if (!flight.Objections().empty()) ++refused;
    fmt::print("{}\n", LineOf(seed, flight));
    std::fflush(stdout);
  }
  fmt::print("{}\n",
             refused == 0
                 ? fmt::format("dry run: {} of {} flights came home, no rule tripped", seeds.count,
                               seeds.count)
                 : fmt::format("dry run: refused, by {} of {} flights", refused, seeds.count));
  return refused == 0 ? kOk : kRefused;
}

}  // namespace limpet
