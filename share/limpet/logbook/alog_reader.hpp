// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "limpet/core/expected.hpp"
#include "limpet/core/message.hpp"

namespace limpet {

/// One line of a log. Views last until the next call of the reader.
struct AlogEntry {
  double time = 0.0;  ///< seconds since the log's start
  std::string_view name;
  std::string_view source;
  std::string_view aux;          ///< what follows `source:`, else empty
  std::string_view value;        ///< text, escapes undone; a number without its padding
  std::optional<double> number;  ///< if the value is a number (or marked D:)
};

/// Streams an .alog file, ours or MOOS's, in file order. Lines that are no entry (comments, broken
/// ones, lines without value) are skipped and counted; a last line without its end is torn and
/// dropped. Escapes are undone if the banner announces them, as AlogWriter's does.
class AlogReader {
 public:
  [[nodiscard]] static Expected<AlogReader> Open(const std::filesystem::path& file);
  /// Reads from memory; `text` must outlive the reader.
  [[nodiscard]] static AlogReader OfText(std::string_view text);

  /// The next entry, or false at the end.
  [[nodiscard]] bool Next(AlogEntry& entry);

  /// MOOS time of the log's start, from the banner; nothing if it has none.
  [[nodiscard]] std::optional<Seconds> start() const { return start_; }
  /// Lines so far that were neither entries nor comments.
  [[nodiscard]] std::size_t skipped_lines() const { return skipped_; }
  [[nodiscard]] bool has_torn_end() const { return has_torn_end_; }

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using Handle = std::unique_ptr<std::FILE, Closer>;

  AlogReader() = default;
  [[nodiscard]] bool NextLine(std::string_view& line);
  [[nodiscard]] bool Refill();
  void ReadComment(std::string_view line);
  [[nodiscard]] bool ReadEntry(std::string_view line, AlogEntry& entry);
  void ReadValue(std::string_view text, AlogEntry& entry);

  Handle file_;
  std::string buffer_;        ///< of a file
  std::string_view pending_;  ///< unread part of buffer_, or of the text
  std::string unescaped_;
  std::optional<Seconds> start_;
  std::size_t skipped_ = 0;
  bool has_escapes_ = false;
  bool has_type_marks_ = false;
  bool has_torn_end_ = false;
};

/// A binary value's place in the .blog file.
struct BlogSpan {
  std::string file;
  std::size_t offset = 0;
  std::size_t bytes = 0;
};
/// Parses `<MOOS_BINARY>File=f,Offset=n,Bytes=m</MOOS_BINARY>`; nothing if it is no such marker.
[[nodiscard]] std::optional<BlogSpan> ParseBlogMarker(std::string_view value);
/// Reads a binary value from the .blog file in `folder`.
[[nodiscard]] Expected<Binary> ReadBlog(const std::filesystem::path& folder, const BlogSpan& span);

}  // namespace limpet
