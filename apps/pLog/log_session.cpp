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
    SyncFileNames(folder);
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

bool LogSession::Save() { return thread_ ? thread_->is_good() : !files_ || files_->Flush(); }

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
