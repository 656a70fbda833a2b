// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

#include "limpet/core/expected.hpp"
#include "limpet/core/message.hpp"
#include "limpet/durable/append_file.hpp"
#include "limpet/logbook/alog_format.hpp"
#include "limpet/logbook/blog.hpp"
#include "limpet/logbook/log_buffer.hpp"

namespace limpet {

/// Appends messages to an .alog file; binary values go to the .blog file beside it. Buffers up to
/// 256 KiB: Flush hands it to the system, Sync to the disk. While the disk is full up to 4 MiB
/// wait for room.
///
/// No value breaks a line: in strings a line feed is written `\n`, a carriage return `\r`, a NUL
/// `\0`, a backslash `\\` and a leading blank `\ `. The banner's fifth line says so, and AlogReader
/// undoes it where that line stands; MOOS tools take it for a comment. Blanks in names and sources
/// become `_`.
class AlogWriter {
 public:
  /// Creates or empties `file`. Times in it count from `start`. Binary values go to `blog`, by
  /// default the file of the same stem.
  [[nodiscard]] static Expected<AlogWriter> Open(const std::filesystem::path& file, Seconds start,
                                                 const AlogOptions& options,
                                                 std::shared_ptr<BlogWriter> blog = nullptr,
                                                 FileSystem& disk = RealFileSystem());
  /// Goes on at the end of `file` with a comment that says so; half a line there goes.
  [[nodiscard]] static Expected<AlogWriter> Continue(const std::filesystem::path& file,
                                                     Seconds start, const AlogOptions& options,
                                                     std::shared_ptr<BlogWriter> blog = nullptr,
                                                     FileSystem& disk = RealFileSystem());
  AlogWriter(AlogWriter&&) noexcept = default;
  AlogWriter& operator=(AlogWriter&&) noexcept = default;
  AlogWriter(const AlogWriter&) = delete;
  AlogWriter& operator=(const AlogWriter&) = delete;
  /// Flushes.
  ~AlogWriter();

  void Write(const Message& message);
  /// A line for people, which readers skip.
  void WriteComment(std::string_view text);
  /// False while something cannot be written, e.g. on a full disk.
  bool Flush();
  /// The bytes of binary values first: a line on the disk never points at what is not there.
  bool Sync();
  /// Why the last of these said false.
  [[nodiscard]] std::error_code trouble() const;
  [[nodiscard]] LogLosses losses() const;

 private:
  AlogWriter(AppendFile file, std::shared_ptr<BlogWriter> blog, AlogFormat format)
      : lines_(std::move(file)), blog_(std::move(blog)), format_(std::move(format)) {}

  LogBuffer lines_;
  std::shared_ptr<BlogWriter> blog_;  ///< null: moved from
  AlogFormat format_;
  std::uint64_t unsynced_binaries_ = 0, binaries_in_doubt_ = 0;
};

}  // namespace limpet
