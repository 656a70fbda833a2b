// SPDX-License-Identifier: MIT
#include "limpet/durable/disk_jobs.hpp"

#include <utility>

#include "limpet/durable/background_thread.hpp"

namespace limpet {

DiskJobs::DiskJobs(bool has_thread) {
  if (has_thread) {
    thread_ = BackgroundThread([this] { Run(); });
  }
}

DiskJobs::~DiskJobs() {
  {
    const std::lock_guard lock(mutex_);
    is_stopped_ = true;
  }
  wake_.notify_one();
  if (thread_.joinable()) {
    thread_.join();
  }
}

void DiskJobs::Put(std::function<void()> job) {
  if (!thread_.joinable()) {
    job();
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
  }
  wake_.notify_one();
}

bool DiskJobs::is_idle() const {
  const std::lock_guard lock(mutex_);
  return jobs_.empty();
}

void DiskJobs::Wait() {
  std::unique_lock lock(mutex_);
  done_.wait(lock, [this] { return jobs_.empty(); });
}

void DiskJobs::Run() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return !jobs_.empty() || is_stopped_; });
    if (jobs_.empty()) {
      return;
    }
    const std::function<void()>& job = jobs_.front();  // a deque that grows leaves it where it is
    lock.unlock();
    job();
    lock.lock();
    jobs_.pop_front();
    done_.notify_all();
  }
}

}  // namespace limpet
