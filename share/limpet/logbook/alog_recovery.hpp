// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "limpet/logbook/alog_reader.hpp"

namespace limpet {

/// Separates what of a torn log is sound from what a kill, a power cut or a bad disk left. Sound
/// are entries whose binary value is where it should be, comments, and lines that are text (a MOOS
/// log has such: the rest of a string with line feeds).
class AlogRecovery {
 public:
  /// `folder`: where the log's .blog files lie.
  explicit AlogRecovery(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// True if the line is to be kept.
  [[nodiscard]] bool Keeps(const AlogLine& line, const AlogEntry& entry);

  [[nodiscard]] std::uint64_t entries() const { return entries_; }
  /// Kept lines that are text but neither entry nor comment.
  [[nodiscard]] std::uint64_t other_lines() const { return other_lines_; }
  [[nodiscard]] std::uint64_t damaged_lines() const { return damaged_lines_; }
  /// Entries dropped because their bytes are missing in the .blog file.
  [[nodiscard]] std::uint64_t lost_binaries() const { return lost_binaries_; }
  /// Name and true size of each .blog file that entries refer to; nothing: missing.
  [[nodiscard]] const std::map<std::string, std::optional<std::uintmax_t>>& blogs() const {
    return blogs_;
  }

 private:
  [[nodiscard]] bool HasBytes(const BlogSpan& span);

  std::filesystem::path folder_;
  std::map<std::string, std::optional<std::uintmax_t>> blogs_;
  std::uint64_t entries_ = 0;
  std::uint64_t other_lines_ = 0;
  std::uint64_t damaged_lines_ = 0;
  std::uint64_t lost_binaries_ = 0;
};

}  // namespace limpet
