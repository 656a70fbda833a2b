// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "limpet/core/random.hpp"
#include "tests/soak/soak_plan.hpp"

namespace limpet {

/// One life of a process, sampled; times are real seconds since its first sample.
struct ProcessLife {
  std::string name;
  std::vector<double> times_s, resident_mib;
  std::vector<int> descriptors;
};

/// What came of one run.
struct SoakRun {
  int seed = 0;
  std::string faults;            ///< as the scenario has them
  std::string ended;             ///< MISSION_END; empty: it was not said
  std::optional<double> down_m;  ///< true depth at the end
  bool was_cut = false;          ///< it took too long
  int exit_code = 0;             ///< of the launcher
  double real_s = 0.0;           ///< how long it took
  int unreadable_logs = 0, logs = 0;
  std::map<pid_t, ProcessLife> lives;
  std::map<std::string, int> kills, stops;                ///< of each app
  std::map<std::string, std::vector<double>> restarts_s;  ///< after a kill
  std::vector<double> round_trips_ms;

  /// What is wrong with it, in words; empty: nothing.
  [[nodiscard]] std::string Complaint() const;
};

/// Where a soak finds and puts things.
struct SoakPlaces {
  std::filesystem::path source, programs, scratch;
};

/// Launches the mission, hits its processes, and waits for its end. Throws std::runtime_error if it
/// cannot be launched at all.
[[nodiscard]] SoakRun RunOnce(const SoakPlan& plan, const SoakPlaces& places, int seed,
                              Random& random);

}  // namespace limpet
