// SPDX-License-Identifier: MIT
#include "apps/pLog/log_session.hpp"

#include <utility>

#include "limpet/core/require.hpp"

namespace limpet {

std::optional<Error> LogSession::Open(const std::filesystem::path& folder, const std::string& stem,
                                      Seconds start, const LogFilesOptions& options) {
  LIMPET_REQUIRE(!is_open(), "a session is open already");
  Expected<LogFiles> files = LogFiles::Open(folder, stem, start, options);
  if (!files) {
    return files.error();
  }
  if (has_thread_) {
    thread_ = std::make_unique<LogThread>(*std::move(files));
  } else {
    files_ = *std::move(files);
  }
  return std::nullopt;
}

bool LogSession::Put(LogRecord record) {
  LIMPET_REQUIRE(is_open(), "no session is open");
  if (thread_) {
    return thread_->Put(std::move(record));
  }
  files_->Put(record);
  return true;
}

std::error_code LogSession::Save() {
  if (thread_) {
    return thread_->trouble();
  }
  return !files_ || files_->Flush() ? std::error_code() : files_->trouble();
}

LogLosses LogSession::losses() const {
  LogLosses losses;
  if (files_) {
    losses += files_->losses();
  }
  const auto add = [&losses](const LogThread& thread) {
    losses += thread.losses();
    losses.dropped += thread.dropped();
  };
  if (thread_) {
    add(*thread_);
  }
  return losses;
}

void LogSession::Close() {
  std::erase_if(closing_, [](const auto& thread) { return thread->is_finished(); });
  if (thread_) {
    thread_->Stop();
    closing_.push_back(std::move(thread_));
  }
  if (files_) {
    files_->Flush();
    files_.reset();
  }
}

}  // namespace limpet
