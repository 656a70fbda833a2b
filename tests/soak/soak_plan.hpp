// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "limpet/core/params.hpp"

namespace limpet {

/// What a soak runs, what it does to it, and what it must not exceed: a block `soak` of a text in
/// the form of a mission file. Times are real time unless they say otherwise.
struct SoakPlan {
  std::string mission = "missions/basin";
  std::string camera = "boxes";
  double warp = 5.0;
  Seconds duration{120.0};
  Seconds run_longest{1800.0};
  Seconds kill_every{10.0};
  double stop_share = 0.3;
  int faults_per_run = 1;
  std::vector<std::string> fault{};
  int seed = 1;
  Seconds warm_up{20.0};
  Seconds least_watch{20.0};
  double most_slope_mib_per_h = 100.0;
  double most_memory_mib = 4096.0;
  int most_descriptor_growth = 8;
  double most_round_trip_ms = 50.0;
  Seconds most_restart{15.0};

  template <class Visitor>
  void Describe(Visitor& visit) {
    visit("mission", mission, "Folder of the mission, from the source's root");
    visit.Choice("camera", camera, "Of the simulated vehicle", {"boxes", "rendered"});
    visit("warp", warp, "Vehicle time per real time", InRange(0.1, 100.0));
    visit("duration_s", duration, "No run begins later", InRange(Seconds(1.0), Seconds(1e6)));
    visit("run_longest_s", run_longest, "A run that takes longer is ended, and counts as failed",
          InRange(Seconds(1.0), Seconds(1e6)));
    visit("kill_every_s", kill_every, "Mean time between two processes that are hit; 0: none is",
          InRange(Seconds(0.0), Seconds(1e6)));
    visit("stop_share", stop_share, "Share of them that are halted, not killed", InRange(0.0, 1.0));
    visit("faults_per_run", faults_per_run,
          "Drawn from `fault`, in a phase and at a time at random", InRange(0, 20));
    visit("fault", fault, "One that a run may have (limpet describe faults)");
    visit("seed", seed, "Of kills and faults, and of the first run", InRange(0, 1000000));
    visit("warm_up_s", warm_up, "A process' memory counts from so long after its start",
          InRange(Seconds(0.0), Seconds(1e5)));
    visit("least_watch_s", least_watch, "And only if it then lives so long",
          InRange(Seconds(1.0), Seconds(1e5)));
    visit("most_slope_mib_per_h", most_slope_mib_per_h,
          "Bound: growth of any app's memory, per hour of vehicle time", InRange(0.0, 1e6));
    visit("most_memory_mib", most_memory_mib, "Bound: memory of any process", InRange(1.0, 1e6));
    visit("most_descriptor_growth", most_descriptor_growth,
          "Bound: files that any process opens more than it had after warm_up_s",
          InRange(0, 100000));
    visit("most_round_trip_ms", most_round_trip_ms,
          "Bound: 95 % of mail comes back from the database within that", InRange(0.01, 1e5));
    visit("most_restart_s", most_restart, "Bound: a killed process runs again within that",
          InRange(Seconds(0.1), Seconds(1e4)));
  }
};

/// Throws ConfigError with file and line.
[[nodiscard]] SoakPlan LoadSoakPlan(const std::filesystem::path& file);

}  // namespace limpet
