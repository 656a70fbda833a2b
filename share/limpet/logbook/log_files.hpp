// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>

#include "limpet/core/expected.hpp"
#include "limpet/durable/file_system.hpp"
#include "limpet/logbook/alog_writer.hpp"
#include "limpet/logbook/log_losses.hpp"
#include "limpet/logbook/log_record.hpp"
#include "limpet/logbook/slog_writer.hpp"

namespace limpet {

struct LogFilesOptions {
  AlogOptions lines;
  bool has_async = true;                      ///< .alog
  bool has_excluded = false;                  ///< .xlog
  bool has_system = false;                    ///< .ylog
  std::optional<SlogWriter::Columns> sync{};  ///< .slog
  bool compresses = false;  ///< at the end .alog and .xlog become .alog.gz and .xlog.gz
  bool continues = false;   ///< goes on in the files that are there; only the .slog is a new one
  FileSystem* disk = &RealFileSystem();  ///< outlives the files
};

/// The files of one logging session: <folder>/<stem>.alog, .slog, .xlog, .ylog and .blog. What is
/// for a file that the options leave out is dropped. Not thread-safe: see LogThread.
class LogFiles {
 public:
  [[nodiscard]] static Expected<LogFiles> Open(const std::filesystem::path& folder,
                                               const std::string& stem, Seconds start,
                                               const LogFilesOptions& options);

  void Put(const LogRecord& record);
  /// Writes to the system, so that it outlives the process. False while something cannot be
  /// written.
  bool Flush();
  /// Writes to the disk, so that it outlives a power cut.
  bool Sync();
  /// The last call: syncs, and compresses if asked to.
  bool Close();
  /// Why the last of these said false.
  [[nodiscard]] std::error_code trouble() const;
  [[nodiscard]] LogLosses losses() const;

 private:
  LogFiles() = default;
  [[nodiscard]] std::filesystem::path PathOf(const char* extension) const;
  /// <stem>_2.slog and so on if there is one.
  [[nodiscard]] std::filesystem::path NewSyncPath() const;
  [[nodiscard]] std::optional<AlogWriter>& WriterOf(LogLine::File file);
  void Keep(const FileCopy& copy);

  std::filesystem::path folder_;
  std::string stem_;
  std::optional<AlogWriter> async_;
  std::optional<AlogWriter> excluded_;
  std::optional<AlogWriter> system_;
  std::optional<SlogWriter> sync_;
  bool compresses_ = false;
  FileSystem* disk_ = nullptr;
};

}  // namespace limpet
