// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "limpet/app/host_faults.hpp"
#include "limpet/launch/community_watch.hpp"
#include "limpet/launch/launch_plan.hpp"
#include "limpet/launch/supervisor.hpp"
#include "limpet/mission/fault_schedule.hpp"
#include "limpet/topics/safety.hpp"

namespace limpet {

/// The faults of a simulated vehicle's scenario that no app of it makes, in a live mission: of its
/// processes, which are really halted or killed, of what is measured of them, of the wall clock and
/// the disk as the processes see them.
class LaunchFaults {
 public:
  /// None where no vehicle is simulated, whatever lies beside the mission. Throws ConfigError where
  /// an app is to fail that is not launched.
  explicit LaunchFaults(const LaunchPlan& plan);

  [[nodiscard]] bool are_none() const { return schedule_.faults().empty(); }
  /// Gives its processes the page of faults; to be called before the first of them starts.
  void Prepare(Supervisor& supervisor) const;
  /// Listens for what the faults wait for.
  void Listen(CommunityWatch& watch) const;
  /// What is so at `now` (MOOS time).
  void Apply(CommunityWatch& watch, Supervisor& supervisor, Seconds now);
  /// Memory of all processes, in place of what they have [MiB]; nothing: as it is.
  [[nodiscard]] std::optional<double> memory_mib() const;
  /// Load in place of the busiest process' load; nothing: as it is.
  [[nodiscard]] std::optional<ProcessorLoad> processor() const;

 private:
  void Hear(const CommunityWatch& watch);
  /// The fault of that number has begun or is over.
  void Switch(std::size_t index, Supervisor& supervisor);
  /// Halts the helm after a decision, and lets it go on when that has taken its time.
  void SlowPlanner(CommunityWatch& watch, Supervisor& supervisor, Seconds now);

  FaultSchedule schedule_;
  std::vector<bool> is_active_;             ///< as applied
  std::map<std::string, int> heard_times_;  ///< by variable
  std::optional<Seconds> plans_until_;      ///< of a planner that is slow
  double plan_s_ = 0.0;
  std::optional<HostFaultControl> host_;  ///< of a mission with faults
};

}  // namespace limpet
