// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "limpet/app/embedded.hpp"
#include "limpet/core/message.hpp"
#include "limpet/mission/fault_schedule.hpp"
#include "limpet/mission/mission_file.hpp"

namespace limpet {

/// The faults of a scenario that no app of it makes: apps that hang, and the disk.
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
  /// Of several the one that lets least through.
  [[nodiscard]] FailingFileSystem::Fault DiskFault() const;

  FaultSchedule schedule_;
  std::vector<bool> is_active_;  ///< as applied
};

}  // namespace limpet
