// SPDX-License-Identifier: MIT
// A sign of life from a process to its launcher that needs no database: a counter in memory that
// both have mapped. The launcher makes it (LIMPET_BEAT_FD), the process counts it up.
#pragma once

#include <atomic>
#include <cstdint>

#include "limpet/app/shared_memory.hpp"

namespace limpet {

/// The counter as both sides see it. 0: the process does not want to be watched (not started up
/// yet, ending, or not one of ours).
struct HeartbeatPage {
  std::atomic<std::uint64_t> count{0};
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free, "shared between processes");
};

/// The process's side. Without a launcher it does nothing.
class Heartbeat {
 public:
  static constexpr const char* kVariable = "LIMPET_BEAT_FD";

  /// Takes what the environment names. To be made before any thread.
  Heartbeat();
  ~Heartbeat() { Pause(); }
  Heartbeat(const Heartbeat&) = delete;
  Heartbeat& operator=(const Heartbeat&) = delete;

  /// Alive, and watched from now on: the next beat must come before the launcher's patience ends.
  void Beat();
  /// Not watched until the next beat: for work that may take its time.
  void Pause();

 private:
  SharedMemory memory_;
  HeartbeatPage* page_ = nullptr;
  std::uint64_t count_ = 0;
};

/// The launcher's side: one counter for one process and its successors. Descriptor -1 and count 0
/// if the system gives none.
class HeartbeatMonitor {
 public:
  HeartbeatMonitor();

  /// Descriptor of the shared page, to be inherited by the process that is watched.
  [[nodiscard]] int descriptor() const { return memory_.descriptor(); }
  [[nodiscard]] std::uint64_t count() const;
  /// Starts anew for another process.
  void Reset();

 private:
  SharedMemory memory_;
  HeartbeatPage* page_ = nullptr;
};

}  // namespace limpet
