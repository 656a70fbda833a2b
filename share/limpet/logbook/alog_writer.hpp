// SPDX-License-Identifier: MIT
// .alog files as MOOS's logger writes them: a banner, then one line per message.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "limpet/core/expected.hpp"
#include "limpet/core/message.hpp"

namespace limpet {

struct AlogOptions {
  int double_precision = 5;              ///< decimals
  bool has_source_aux = false;           ///< source becomes `app:aux`
  bool marks_data_type = false;          ///< values begin with D: or S:
  bool marks_other_communities = false;  ///< `@community` after foreign sources
  std::string community{};               ///< own one
};

/// Appends messages to an .alog file; binary values go to the .blog file beside it. Buffers up to
/// 256 KiB: Flush hands it to the system, Sync to the disk.
///
/// No value breaks a line: in strings a line feed is written `\n`, a carriage return `\r`, a
/// backslash `\\` and a leading blank `\ `. The banner's fifth line says so, and AlogReader undoes
/// it where that line stands; MOOS tools take it for a comment. Blanks in names and sources become
/// `_`.
class AlogWriter {
 public:
  /// Creates or empties `file`. Times in it count from `start`; the banner's date is derived from
  /// it.
  [[nodiscard]] static Expected<AlogWriter> Open(const std::filesystem::path& file, Seconds start,
                                                 const AlogOptions& options);
  AlogWriter(AlogWriter&&) noexcept = default;
  AlogWriter& operator=(AlogWriter&&) noexcept = default;
  AlogWriter(const AlogWriter&) = delete;
  AlogWriter& operator=(const AlogWriter&) = delete;
  /// Flushes.
  ~AlogWriter();

  void Write(const Message& message);
  /// False once anything could not be written, e.g. on a full disk.
  bool Flush();
  bool Sync();

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using Handle = std::unique_ptr<std::FILE, Closer>;

  AlogWriter(Handle file, std::filesystem::path path, Seconds start, AlogOptions options);
  void WriteBanner();
  void AppendSource(const Message& message);
  void AppendValue(const Value& value);
  void AppendBinary(const Binary& bytes);

  Handle file_;
  std::filesystem::path path_;
  Seconds start_;
  AlogOptions options_;
  std::string buffer_;
  Handle blog_;
  std::uint64_t blog_bytes_ = 0;
  bool is_good_ = true;
};

/// `Sat Nov 21 07:20:00 2026`, UTC.
[[nodiscard]] std::string CalendarText(Seconds utc);

}  // namespace limpet
