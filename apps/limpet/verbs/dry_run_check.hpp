// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limpet/preflight/preflight.hpp"
#include "limpet/safety_trials/dry_run.hpp"

namespace limpet {

/// How many flights, and the seed of the first.
struct DryRunSeeds {
  std::uint64_t first = 1;
  int count = 3;
};

struct SeedFlight {
  std::uint64_t seed = 0;
  DryFlight flight;
};

/// The flights of a dry run.
struct DryRun {
  std::vector<SeedFlight> flights;
  bool is_interrupted = false;

  [[nodiscard]] int refused() const;
  /// 0 or 3; 1 if it was interrupted.
  [[nodiscard]] int ExitCode() const;
};

/// Flies a mission embedded, all its sessions once for each seed, up to one that is refused; `told`
/// hears of each flight at its end. `path`: a mission folder or .moos file; `change` is made in it
/// first. Throws UsageError for a mission that such a flight says nothing of.
[[nodiscard]] DryRun FlyDryRun(const std::filesystem::path& path, const MissionChange& change,
                               const DryRunSeeds& seeds,
                               const std::function<void(const SeedFlight&)>& told);
void PrintFlight(const SeedFlight& flown);
void PrintVerdict(const DryRun& run);
[[nodiscard]] nlohmann::ordered_json JsonOf(const DryRun& run);

}  // namespace limpet
