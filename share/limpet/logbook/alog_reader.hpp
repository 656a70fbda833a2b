// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/core/message.hpp"
#include "limpet/logbook/blog.hpp"
#include "limpet/logbook/gzip_file.hpp"

namespace limpet {

/// An entry of a log. Views last until the next call of the reader.
struct AlogEntry {
  double time = 0.0;  ///< seconds since the log's start
  std::string_view name;
  std::string_view source;
  std::string_view aux;          ///< what follows `source:`, else empty
  std::string_view value;        ///< text, escapes undone; a number without its padding
  std::optional<double> number;  ///< if the value is a number (or marked D:)
};

/// A line of a log, whatever it is. The view lasts until the next call of the reader.
struct AlogLine {
  enum class Kind { kEntry, kComment, kBlank, kBroken };
  Kind kind = Kind::kBlank;
  std::string_view text;     ///< without its end
  std::size_t number = 0;    ///< from 1
  const char* problem = "";  ///< of a broken line
};

/// Streams an .alog file, ours or MOOS's, plain or gzip, in file order. Whatever the file holds, it
/// reads on: lines that are no entry (comments, broken ones, lines without value, of NULs as a
/// power cut leaves them, of more than 128 MiB) are skipped and counted; a last line without its
/// end is torn and dropped. Escapes are undone if the banner announces them, as AlogWriter's does.
class AlogReader {
 public:
  [[nodiscard]] static Expected<AlogReader> Open(const std::filesystem::path& file);
  /// Reads from memory; `text` must outlive the reader.
  [[nodiscard]] static AlogReader OfText(std::string_view text);

  /// The next entry, or false at the end.
  [[nodiscard]] bool Next(AlogEntry& entry);
  /// The next line of any kind, or false at the end; `entry` is set if the line is one.
  [[nodiscard]] bool NextLine(AlogLine& line, AlogEntry& entry);

  /// MOOS time of the log's start, from the banner; nothing if it has none.
  [[nodiscard]] std::optional<Seconds> start() const { return start_; }
  /// Lines so far that were neither entries nor comments.
  [[nodiscard]] std::size_t skipped_lines() const { return skipped_; }
  struct Skipped {
    std::size_t line = 0;
    const char* problem = "";
  };
  /// The first few of them.
  [[nodiscard]] const std::vector<Skipped>& first_skipped() const { return first_skipped_; }
  [[nodiscard]] bool has_torn_end() const { return has_torn_end_; }
  /// True if the file could not be read to its end.
  [[nodiscard]] bool has_failed() const { return file_ && file_->has_failed(); }
  /// How far reading is in the file as it lies on the disk, bytes.
  [[nodiscard]] std::uint64_t position() const { return file_ ? file_->position() : 0; }

 private:
  AlogReader() = default;
  [[nodiscard]] bool TakeLine(std::string_view& line);
  [[nodiscard]] bool Refill();
  void ReadComment(std::string_view line);
  /// Null, or why the line is no entry.
  [[nodiscard]] const char* ReadEntry(std::string_view line, AlogEntry& entry);
  void ReadValue(std::string_view text, AlogEntry& entry);
  void Skip(AlogLine& line, const char* problem);

  std::optional<SequentialFile> file_;
  std::string buffer_;        ///< of a file
  std::string_view pending_;  ///< unread part of buffer_, or of the text
  std::string unescaped_;
  std::optional<Seconds> start_;
  std::size_t line_number_ = 0;
  std::size_t skipped_ = 0;
  std::vector<Skipped> first_skipped_;
  bool has_escapes_ = false;
  bool has_type_marks_ = false;
  bool has_torn_end_ = false;
  bool is_too_long_ = false;  ///< the line just taken is only the end of one
};

}  // namespace limpet
