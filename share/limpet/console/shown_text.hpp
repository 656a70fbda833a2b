// SPDX-License-Identifier: MIT
// Foreign text on a terminal: one line, cut to a width, and nothing in it that a terminal obeys.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "limpet/core/message.hpp"

namespace limpet {

/// No limit on columns.
inline constexpr std::size_t kAnyWidth = static_cast<std::size_t>(-1);

/// `text` in at most `width` columns; what is cut off is marked by `~`. Control characters become
/// \n, \t, \x1b...; so do bytes that are no UTF-8, and characters that reorder text or whose width
/// terminals disagree on. Without `keeps_utf8` every character outside ASCII does.
[[nodiscard]] std::string OneLine(std::string_view text, std::size_t width = kAnyWidth,
                                  bool keeps_utf8 = true);
/// Text of several lines: each as OneLine makes it. For a person's eyes, whatever the stream is.
[[nodiscard]] std::string ShownLines(std::string_view text, bool keeps_utf8 = true);
/// Columns of what OneLine returns: its characters.
[[nodiscard]] std::size_t ColumnsOf(std::string_view line);

/// True if the environment (LC_ALL, LC_CTYPE, LANG) says that terminals read UTF-8.
[[nodiscard]] bool TerminalReadsUtf8();

/// A value as far as a tool keeps it: a picture of megabytes is not worth its memory here.
struct KeptValue {
  static constexpr std::size_t kMostBytes = 4096;
  char type = '~';       ///< D, S, B, or ~ if never written
  double number = 0.0;   ///< if D
  std::string head{};    ///< the first bytes, if S or B
  std::size_t size = 0;  ///< bytes in all
  std::size_t hash = 0;  ///< of all of them

  [[nodiscard]] static KeptValue Of(const Value& value);
  [[nodiscard]] bool operator==(const KeptValue& other) const = default;
  /// The value without what lies behind its first `bytes`.
  [[nodiscard]] KeptValue Shortened(std::size_t bytes) const;
};

/// A number to six decimals, a small one to six digits; text by OneLine; of binary values
/// the size and the first bytes.
[[nodiscard]] std::string ShownValue(const KeptValue& value, std::size_t width = kAnyWidth,
                                     bool keeps_utf8 = true);
/// `512 B`, `1.4 kB`, `2.0 MB`.
[[nodiscard]] std::string ShownSize(std::size_t bytes);
/// `3.2`, `59.9`, `12m05`, `3h07`, `2d04` [s]; at most six columns.
[[nodiscard]] std::string ShownAge(Seconds age);
/// Three digits [Hz]; `-` if it is not known.
[[nodiscard]] std::string ShownRate(double hz);

}  // namespace limpet
