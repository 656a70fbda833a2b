// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>

#include "limpet/durable/synced_append.hpp"

namespace limpet {

/// Appends to a file on a thread of its own, so that no disk ever delays who hands over: what it is
/// given is with the system at once, and on the disk within the sync interval. With the first
/// trouble it ends and removes the file: one with a gap would be believed.
///
/// Put and the getters may be called from one other thread at a time.
class AppendThread {
 public:
  struct Limits {
    std::size_t queue_bytes = std::size_t{64} << 20U;  ///< more than that waiting is trouble, too
    std::chrono::milliseconds sync = SyncTimer::kInterval;
  };
  explicit AppendThread(AppendFile file) : AppendThread(std::move(file), Limits{}) {}
  AppendThread(AppendFile file, Limits limits);
  AppendThread(const AppendThread&) = delete;
  AppendThread& operator=(const AppendThread&) = delete;
  /// Waits until everything is on the disk.
  ~AppendThread();

  void Put(std::string_view bytes);
  /// Ends it as trouble does, without waiting.
  void GiveUp(std::error_code why);
  /// Why it has ended; nothing while it works.
  [[nodiscard]] std::error_code trouble() const { return {trouble_, std::generic_category()}; }

 private:
  void Run();
  /// Waits for bytes, or until a sync is due; false when stopped and none are left.
  [[nodiscard]] bool Take(std::string& bytes);

  SyncedAppend file_;  ///< the thread's alone
  std::size_t queue_limit_;

  std::mutex mutex_;
  std::condition_variable wake_;
  std::string queue_;        ///< guarded by mutex_
  bool is_stopped_ = false;  ///< guarded by mutex_
  std::atomic<int> trouble_{0};
  std::thread thread_;  ///< last: it uses all of the above
};

}  // namespace limpet
