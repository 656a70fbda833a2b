// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/logbook/log_files.hpp"
#include "limpet/logbook/log_thread.hpp"

namespace limpet {

/// The files that pLog now writes: by itself when embedded, through a thread in a community.
class LogSession {
 public:
  explicit LogSession(bool has_thread) : has_thread_(has_thread) {}

  /// REQUIRES: !is_open(). Why it failed, if it did.
  [[nodiscard]] std::optional<Error> Open(const std::filesystem::path& folder,
                                          const std::string& stem, Seconds start,
                                          const LogFilesOptions& options);
  [[nodiscard]] bool is_open() const { return files_ || thread_; }
  /// REQUIRES: is_open(). False if the record was dropped.
  bool Put(LogRecord record);
  /// Hands what was put to the system; with a thread that happens by itself. Why something cannot
  /// be written now; nothing if all can.
  [[nodiscard]] std::error_code Save();
  /// What is missing in the files that are open.
  [[nodiscard]] LogLosses losses() const;
  /// What was put is still written; nobody waits for it before this object's end.
  void Close();

 private:
  bool has_thread_;
  std::optional<LogFiles> files_;
  std::unique_ptr<LogThread> thread_;
  std::vector<std::unique_ptr<LogThread>> closing_;
};

}  // namespace limpet
