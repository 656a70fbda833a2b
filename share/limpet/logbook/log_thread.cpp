// SPDX-License-Identifier: MIT
#include "limpet/logbook/log_thread.hpp"

#include <fmt/format.h>

#include "limpet/durable/background_thread.hpp"

namespace limpet {

LogThread::LogThread(LogFiles files, Limits limits)
    : files_(std::move(files)), limits_(limits), timer_(limits.sync, SyncTimer::Clock::now()) {
  thread_ = BackgroundThread([this] { Run(); });
}

LogThread::~LogThread() {
  Stop();
  thread_.join();
}

bool LogThread::Put(LogRecord record) {
  const std::size_t size = SizeOf(record);
  bool should_wake = false;
  {
    const std::lock_guard lock(mutex_);
    if (is_stopped_ || queued_bytes_ + size > limits_.queue_bytes) {
      ++dropped_;
      return false;
    }
    queue_.push_back(std::move(record));
    queued_bytes_ += size;
    // Half full: no more waiting for company.
    should_wake = is_waiting_ || queued_bytes_ * 2 > limits_.queue_bytes;
    is_waiting_ = false;
  }
  if (should_wake) {
    wake_.notify_one();
  }
  return true;
}

void LogThread::Stop() {
  {
    const std::lock_guard lock(mutex_);
    is_stopped_ = true;
  }
  wake_.notify_one();
}

void LogThread::Run() {
  std::deque<LogRecord> batch;
  while (TakeBatch(batch)) {
    WriteBatch(batch);
    batch.clear();
    SyncIfDue();
  }
  files_.Close();
  settled_ = taken_;
  TellState();
  is_finished_ = true;
}

bool LogThread::TakeBatch(std::deque<LogRecord>& batch) {
  std::unique_lock lock(mutex_);
  const auto has_work = [this] { return !queue_.empty() || is_stopped_; };
  is_waiting_ = queue_.empty();
  if (const auto due = timer_.due()) {
    wake_.wait_until(lock, *due, has_work);
  } else {
    wake_.wait(lock, has_work);
  }
  is_waiting_ = false;
  if (!queue_.empty()) {
    wake_.wait_for(lock, limits_.batch,
                   [this] { return is_stopped_ || queued_bytes_ * 2 > limits_.queue_bytes; });
  }
  batch.swap(queue_);
  queued_bytes_ = 0;
  return !is_stopped_ || !batch.empty();
}

void LogThread::WriteBatch(const std::deque<LogRecord>& batch) {
  for (const LogRecord& record : batch) {
    files_.Put(record);
  }
  if (const std::uint64_t dropped = dropped_; dropped != dropped_noted_) {
    files_.Put(LogComment{fmt::format("{} messages are missing here: the disk was too slow",
                                      dropped - dropped_noted_)});
    dropped_noted_ = dropped;
  }
  if (!batch.empty()) {
    taken_ += batch.size();
    files_.Flush();
    TellState();
    timer_.NoteWrite();
  }
}

void LogThread::SyncIfDue() {
  if (!timer_.IsDue(SyncTimer::Clock::now())) {
    return;
  }
  const bool is_good = files_.Sync();
  timer_.NoteSync(SyncTimer::Clock::now());
  if (is_good) {
    settled_ = taken_;
  } else {
    timer_.NoteWrite();  // again in a while
  }
  TellState();
}

void LogThread::TellState() {
  trouble_ = files_.trouble().value();
  const std::lock_guard lock(mutex_);
  losses_ = files_.losses();
}

LogLosses LogThread::losses() const {
  const std::lock_guard lock(mutex_);
  return losses_;
}

}  // namespace limpet
