// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace limpet {

/// What waits for a disk, one job after the other: on a thread of its own in a community, so that
/// nobody hangs with a disk that hangs; at once, in the caller's, embedded.
///
/// All calls come from one thread. What a job has written may be read once it is idle.
class DiskJobs {
 public:
  explicit DiskJobs(bool has_thread);
  DiskJobs(const DiskJobs&) = delete;
  DiskJobs& operator=(const DiskJobs&) = delete;
  /// Waits for the jobs that were put.
  ~DiskJobs();

  void Put(std::function<void()> job);
  [[nodiscard]] bool is_idle() const;
  /// Waits until no job is left.
  void Wait();

 private:
  void Run();

  mutable std::mutex mutex_;
  std::condition_variable wake_, done_;
  std::deque<std::function<void()>> jobs_;  ///< guarded by mutex_; the first one is under way
  bool is_stopped_ = false;                 ///< guarded by mutex_
  std::thread thread_;                      ///< last: it uses all of the above
};

}  // namespace limpet
