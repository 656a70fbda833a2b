// SPDX-License-Identifier: MIT
// The text of .alog files, as MOOS's logger writes them: a banner, then one line per message.
#pragma once

#include <string>
#include <string_view>

#include "limpet/core/message.hpp"

namespace limpet {

struct AlogOptions {
  int double_precision = 5;              ///< decimals
  bool has_source_aux = false;           ///< source becomes `app:aux`
  bool marks_data_type = false;          ///< values begin with D: or S:
  bool marks_other_communities = false;  ///< `@community` after foreign sources
  std::string community{};               ///< own one
  double time_warp = 1.0;                ///< MOOS time / warp is the date in the banner
};

/// Turns messages into lines; touches no file.
class AlogFormat {
 public:
  /// Times in the log count from `start`; the banner's date is derived from it.
  AlogFormat(Seconds start, AlogOptions options);

  void AppendBanner(std::string& out, std::string_view file_name) const;
  /// One line with its end. `blog_marker` stands for the bytes of a binary value.
  void AppendLine(std::string& out, const Message& message,
                  std::string_view blog_marker = {}) const;

 private:
  void AppendSource(std::string& out, const Message& message) const;

  Seconds start_;
  AlogOptions options_;
};

/// The lines that every log of a session begins with; `notes` are further comment lines, without
/// their ends.
void AppendLogBanner(std::string& out, std::string_view file_name, Seconds start, Seconds utc,
                     std::string_view notes);

/// Appends a word (blanks in it become `_`), padded to `width` and followed by a blank.
void AppendLogWord(std::string& out, std::string_view word, std::size_t width);

/// `Sat Nov 21 07:20:00 2026`, UTC.
[[nodiscard]] std::string CalendarText(Seconds utc);

}  // namespace limpet
