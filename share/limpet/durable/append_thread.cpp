// SPDX-License-Identifier: MIT
#include "limpet/durable/append_thread.hpp"

#include <utility>

#include "limpet/durable/background_thread.hpp"

namespace limpet {

AppendThread::AppendThread(AppendFile file, Limits limits)
    : file_(std::move(file), limits.sync, SyncTimer::Clock::now()),
      queue_limit_(limits.queue_bytes) {
  thread_ = BackgroundThread([this] { Run(); });
}

AppendThread::~AppendThread() {
  {
    const std::lock_guard lock(mutex_);
    is_stopped_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void AppendThread::Put(std::string_view bytes) {
  bool has_room = false;
  {
    const std::lock_guard lock(mutex_);
    has_room = queue_.size() + bytes.size() <= queue_limit_;
    if (has_room) {
      queue_ += bytes;
    }
  }
  if (has_room) {
    wake_.notify_one();
  } else {
    GiveUp(std::make_error_code(std::errc::device_or_resource_busy));
  }
}

void AppendThread::GiveUp(std::error_code why) {
  {
    const std::lock_guard lock(mutex_);
    queue_.clear();
    is_stopped_ = true;
    trouble_ = why.value();
  }
  wake_.notify_one();
}

void AppendThread::Run() {
  std::string bytes;
  bool is_good = true;
  while (is_good && Take(bytes)) {
    is_good = file_.Write(bytes, SyncTimer::Clock::now());
    bytes.clear();
  }
  is_good = is_good && file_.Sync();
  if (!is_good) {
    GiveUp(file_.trouble());
  }
  if (trouble_ != 0) {
    file_.Discard();
  }
}

bool AppendThread::Take(std::string& bytes) {
  std::unique_lock lock(mutex_);
  const auto has_work = [this] { return !queue_.empty() || is_stopped_; };
  if (const auto due = file_.due()) {
    wake_.wait_until(lock, *due, has_work);
  } else {
    wake_.wait(lock, has_work);
  }
  bytes.swap(queue_);
  return !is_stopped_ || !bytes.empty();
}

}  // namespace limpet
