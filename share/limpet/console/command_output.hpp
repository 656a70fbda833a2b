// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "limpet/durable/append_file.hpp"

namespace limpet {

/// What a command will not do, such as writing over a file; exit code 3.
class Refusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The result of a command: the standard output, or a file that appears under its name only once it
/// is whole and on the disk.
class CommandOutput {
 public:
  /// Throws Refusal if `name` exists and `may_overwrite` is not set, or if it is the input, a
  /// folder or `-`.
  CommandOutput(const std::optional<std::string>& name, bool may_overwrite,
                const std::filesystem::path& input);
  CommandOutput(const CommandOutput&) = delete;
  CommandOutput& operator=(const CommandOutput&) = delete;
  /// Where Commit was not called, nothing is left of a file.
  ~CommandOutput();

  /// Writes `bytes` as they are. Throws std::runtime_error if they cannot be written.
  void Write(std::string_view bytes);
  /// Whole lines that come from elsewhere, without the last end of line: as they are into a file or
  /// a pipe; on a terminal with nothing in them that a terminal obeys.
  void WriteLines(std::string_view text);
  [[nodiscard]] bool is_terminal() const { return is_terminal_; }
  void Commit();
  [[nodiscard]] bool is_file() const { return file_.has_value(); }
  /// Empty for the standard output.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  void HandOver();

  std::filesystem::path path_;
  std::filesystem::path aside_;
  std::optional<AppendFile> file_;
  std::string buffer_;
  bool is_terminal_ = false;
};

}  // namespace limpet
