// SPDX-License-Identifier: MIT
// What every `limpet log` command reads with.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "limpet/console/progress_line.hpp"
#include "limpet/logbook/alog_reader.hpp"

namespace limpet {

/// A log given on the command line: a file, `-` for the standard input, or a folder that holds one
/// log. Shows progress on a big file; Ctrl-C ends the reading.
class LogInput {
 public:
  /// Throws std::runtime_error if there is no such log.
  explicit LogInput(const std::string& name);

  /// Throws std::runtime_error if the file cannot be read on, or on Ctrl-C.
  [[nodiscard]] bool Next(AlogLine& line, AlogEntry& entry);
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] const AlogReader& reader() const { return reader_; }
  /// Bytes on the disk; nothing for a pipe.
  [[nodiscard]] std::optional<std::uintmax_t> size() const { return size_; }
  /// Says on stderr, with file and line, what of the log was no entry, and whether it is torn.
  void PrintDoubts() const;

 private:
  void ShowProgress();

  std::filesystem::path file_;
  AlogReader reader_;
  std::optional<std::uintmax_t> size_;
  std::optional<ProgressLine> progress_;
  std::uint64_t lines_ = 0;
};

}  // namespace limpet
