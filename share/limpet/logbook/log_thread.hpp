// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <system_error>
#include <thread>

#include "limpet/durable/sync_timer.hpp"
#include "limpet/logbook/log_files.hpp"

namespace limpet {

/// Writes a session's files on a thread of its own, so that a slow disk never delays whoever logs.
/// What it is given is with the system within about 50 ms, so that a kill costs no more, and on the
/// disk within the sync interval, so that a power cut costs no more.
///
/// Put, Stop and the getters may be called from one other thread at a time.
class LogThread {
 public:
  struct Limits {
    std::size_t queue_bytes = std::size_t{64} << 20U;  ///< what waits beyond this is dropped
    std::chrono::milliseconds batch{50};               ///< longest wait for more to write at once
    std::chrono::milliseconds sync = SyncTimer::kInterval;
  };

  explicit LogThread(LogFiles files) : LogThread(std::move(files), Limits{}) {}
  LogThread(LogFiles files, Limits limits);
  LogThread(const LogThread&) = delete;
  LogThread& operator=(const LogThread&) = delete;
  /// Waits until everything is on the disk.
  ~LogThread();

  /// Queues a record; false if it was dropped because the queue is full. The log itself says how
  /// many were, where it happened.
  bool Put(LogRecord record);
  /// Asks for the end: what is queued is still written. Does not wait.
  void Stop();

  /// Records dropped so far because the disk was too slow.
  [[nodiscard]] std::uint64_t dropped() const { return dropped_; }
  /// What is missing in the files.
  [[nodiscard]] LogLosses losses() const;
  /// Why something cannot be written now; nothing if all can.
  [[nodiscard]] std::error_code trouble() const { return {trouble_, std::generic_category()}; }
  /// Records that are on the disk, or are counted as missing.
  [[nodiscard]] std::uint64_t settled() const { return settled_; }
  /// True once Stop was called and everything is on the disk.
  [[nodiscard]] bool is_finished() const { return is_finished_; }

 private:
  void Run();
  /// Waits for records; false when stopped and none are left.
  [[nodiscard]] bool TakeBatch(std::deque<LogRecord>& batch);
  void WriteBatch(const std::deque<LogRecord>& batch);
  void SyncIfDue();
  void TellState();

  LogFiles files_;  ///< the thread's alone
  Limits limits_;
  std::uint64_t dropped_noted_ = 0;  ///< the thread's alone
  std::uint64_t taken_ = 0;          ///< records; the thread's alone
  SyncTimer timer_;                  ///< the thread's alone

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<LogRecord> queue_;   ///< guarded by mutex_; grows without moving what is in it
  std::size_t queued_bytes_ = 0;  ///< guarded by mutex_
  bool is_waiting_ = false;       ///< guarded by mutex_: the thread sleeps until something comes
  bool is_stopped_ = false;       ///< guarded by mutex_
  LogLosses losses_;              ///< guarded by mutex_

  std::atomic<std::uint64_t> dropped_{0};
  std::atomic<std::uint64_t> settled_{0};
  std::atomic<int> trouble_{0};
  std::atomic<bool> is_finished_{false};
  std::thread thread_;  ///< last: it uses all of the above
};

}  // namespace limpet
