// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "limpet/app/embedded.hpp"
#include "limpet/core/message.hpp"
#include "limpet/mission/fault_schedule.hpp"
#include "limpet/mission/mission_file.hpp"

namespace limpet {

/// The faults of a scenario that no app of it makes: apps that hang, the wall clock, and the disk.
class SessionFaults {
 public:
  /// Of the scenario that the mission's vehicle is simulated by; none without one. Throws
  /// ConfigError where an app is to hang that is not launched.
  SessionFaults(const MissionFile& mission, const std::filesystem::path& folder);

  [[nodiscard]] bool AreNone() const { return is_active_.empty(); }
  void Hear(const Message& message) { schedule_.Hear(message.name, message.value); }
  /// What is so now; to be called before each step.
  void Apply(EmbeddedCommunity& community);

 private:
  /// The fault of that number has begun or is over.
  void Switch(std::size_t index, EmbeddedCommunity& community);
  /// WALL_CLOCK as it is now, that stands for LimpetDB's.
  void TellClock(EmbeddedCommunity& community) const;
  /// Of several the one that lets least through.
  [[nodiscard]] FailingFileSystem::Fault DiskFault() const;

  FaultSchedule schedule_;
  std::vector<bool> is_active_;  ///< as applied
  bool is_clock_told_ = false;
  int clock_steps_ = 0;
};

}  // namespace limpet
