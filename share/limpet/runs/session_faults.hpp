// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "limpet/app/embedded.hpp"
#include "limpet/core/message.hpp"
#include "limpet/mission/fault_schedule.hpp"
#include "limpet/mission/mission_file.hpp"

namespace limpet {

/// The faults of a scenario that no app of it makes: apps that hang or die, the wall clock, and the
/// disk.
class SessionFaults {
 public:
  /// Of the scenario that the mission's vehicle is simulated by; none without one. Throws
  /// ConfigError where an app is to hang that is not launched.
  SessionFaults(const MissionFile& mission, const std::filesystem::path& folder);

  [[nodiscard]] bool AreNone() const { return is_active_.empty(); }
  void Hear(const Message& message);
  /// What is so now; to be called before each step.
  void Apply(EmbeddedCommunity& community);

 private:
  /// The fault of that number has begun or is over.
  void Switch(std::size_t index, EmbeddedCommunity& community);
  /// Keeps the helm from going on after a decision, and lets it go on when that has taken its time.
  void SlowPlanner(EmbeddedCommunity& community);
  /// PLAUNCH_STATUS of those that are down, that stands for pLaunch's.
  void TellApps(EmbeddedCommunity& community) const;
  /// WALL_CLOCK as it is now, that stands for LimpetDB's.
  void TellClock(EmbeddedCommunity& community) const;

  FaultSchedule schedule_;
  std::vector<bool> is_active_;                   ///< as applied
  std::optional<Seconds> decided_, plans_until_;  ///< of a planner that is slow
  double plan_s_ = 0.0;
  bool is_clock_told_ = false;
  int clock_steps_ = 0;
};

}  // namespace limpet
