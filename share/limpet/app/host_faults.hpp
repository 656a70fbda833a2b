// SPDX-License-Identifier: MIT
// What a scenario makes fail of the machine that a live mission runs on, its disk and its wall
// clock: the launcher says so in memory that its processes have mapped (LIMPET_HOST_FD).
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

#include "limpet/app/shared_memory.hpp"
#include "limpet/core/units.hpp"
#include "limpet/durable/failing_file_system.hpp"
#include "limpet/mission/fault_schedule.hpp"

namespace limpet {

/// What fails of the disk now; of several the fault that lets least through.
[[nodiscard]] FailingFileSystem::Fault DiskFaultOf(const FaultSchedule& schedule);

/// The page of memory that host and processes share, as both sides see it.
struct HostFaultPage {
  FailingFileSystem::State disk;
  std::atomic<double> wall_ahead{0.0};  ///< of the machine's own [s]
  static_assert(std::atomic<double>::is_always_lock_free &&
                    std::atomic<FailingFileSystem::Fault>::is_always_lock_free &&
                    std::atomic<std::uint64_t>::is_always_lock_free,
                "shared between processes");
};

/// The process's side: of a mission without such faults, the machine as it is.
class HostFaults {
 public:
  static constexpr const char* kVariable = "LIMPET_HOST_FD";

  /// Takes what the environment names. To be made before any thread.
  HostFaults();

  /// A launcher makes the scenario's faults of processes, disk and clock.
  [[nodiscard]] bool are_made() const { return page_ != nullptr; }
  /// Outlived by this.
  [[nodiscard]] FileSystem& disk() const;
  /// What the wall clock is to be ahead of the machine's own.
  [[nodiscard]] Seconds wall_ahead() const;

 private:
  SharedMemory memory_;
  HostFaultPage* page_ = nullptr;
  std::unique_ptr<FailingFileSystem> disk_;
};

/// The launcher's side. Without memory from the system, nothing fails.
class HostFaultControl {
 public:
  HostFaultControl();

  /// Descriptor of the shared page, to be inherited by the processes.
  [[nodiscard]] int descriptor() const { return memory_.descriptor(); }
  void FailDisk(FailingFileSystem::Fault fault);
  /// From now on the disk has so much room left [bytes], or what it has.
  void LimitDisk(std::optional<std::uint64_t> bytes);
  void SetWallAhead(Seconds ahead);

 private:
  SharedMemory memory_;
  HostFaultPage* page_ = nullptr;
};

}  // namespace limpet
