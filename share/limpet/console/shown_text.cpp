// SPDX-License-Identifier: MIT
#include "limpet/console/shown_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

/// Ranges of characters that every terminal shows in one column and in reading order: Latin, Greek,
/// Cyrillic, punctuation, currency, arrows, mathematics, boxes. The soft hyphen, combining marks,
/// what turns the direction of writing and all wide characters lie outside.
struct Range {
  char32_t first, last;
};
constexpr std::array kOneColumn{Range{0xA1, 0xAC},     Range{0xAE, 0x2FF},    Range{0x370, 0x377},
                                Range{0x37A, 0x37F},   Range{0x384, 0x482},   Range{0x48A, 0x52F},
                                Range{0x1E00, 0x1EFF}, Range{0x2010, 0x2027}, Range{0x2030, 0x205E},
                                Range{0x20A0, 0x20BF}, Range{0x2190, 0x21FF}, Range{0x2200, 0x22FF},
                                Range{0x2500, 0x259F}};

bool IsOneColumn(char32_t c) {
  return std::ranges::any_of(kOneColumn, [c](Range r) { return c >= r.first && c <= r.last; });
}

/// The UTF-8 character at the start of `text`: its length, or 0 if it is none.
std::size_t TakeCharacter(std::string_view text, char32_t& character) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC2 ? 2 : 0;
  if (length == 0 || lead > 0xF4 || text.size() < length) {
    return 0;
  }
  character = lead & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xC0U) != 0x80U) {
      return 0;
    }
    character = (character << 6U) | (next & 0x3FU);
  }
  constexpr std::array<char32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = character >= 0xD800 && character <= 0xDFFF;
  return character < kLeast[length] || is_surrogate || character > 0x10FFFF ? 0 : length;
}

/// What stands for the next character of `text`, which is taken off it.
std::string TakePiece(std::string_view& text, bool keeps_utf8) {
  const char c = text[0];
  const auto byte = static_cast<unsigned char>(c);
  std::size_t length = 1;
  std::string piece;
  if (byte >= 0x20 && byte < 0x7F) {
    piece = c;
  } else if (c == '\n' || c == '\r' || c == '\t') {
    piece = c == '\n' ? "\\n" : c == '\r' ? "\\r" : "\\t";
  } else if (byte < 0x80) {
    piece = fmt::format("\\x{:02x}", byte);
  } else {
    char32_t character = 0;
    length = TakeCharacter(text, character);
    piece = length == 0 ? fmt::format("\\x{:02x}", byte)
            : keeps_utf8 && IsOneColumn(character)
                ? std::string(text.substr(0, length))
                : fmt::format("\\u{:04x}", static_cast<unsigned>(character));
    length = std::max<std::size_t>(length, 1);
  }
  text.remove_prefix(length);
  return piece;
}

std::string BinaryText(const KeptValue& value, std::size_t width) {
  std::string text = fmt::format("[{}]", ShownSize(value.size));
  for (std::size_t i = 0; i < value.head.size() && i < 16; ++i) {
    text += fmt::format("{}{:02x}", i % 4 == 0 ? " " : "",
                        static_cast<unsigned>(static_cast<unsigned char>(value.head[i])));
  }
  text += value.size > 16 ? " ..." : "";
  return OneLine(text, width);
}

std::string NumberText(double number) {
  const double size = std::abs(number);
  if (!std::isfinite(number) || size >= 1e15) {
    return TextOf(number);
  }
  if (size < 1e-3 && size > 0.0) {
    return fmt::format("{:.6g}", number);
  }
  std::string text = fmt::format("{:.6f}", number);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) {
    text.pop_back();
  }
  return text;
}

}  // namespace

std::string OneLine(std::string_view text, std::size_t width, bool keeps_utf8) {
  std::string line;
  std::size_t columns = 0;
  std::size_t cut = 0;  // where the line ends if something has to go: room for the mark
  while (!text.empty()) {
    const std::string piece = TakePiece(text, keeps_utf8);
    const std::size_t wide = ColumnsOf(piece);
    if (columns + wide > width) {
      line.resize(cut);
      return width == 0 ? "" : line + '~';
    }
    line += piece;
    columns += wide;
    if (columns < width) {
      cut = line.size();
    }
  }
  return line;
}

std::string ShownLines(std::string_view text, bool keeps_utf8) {
  std::string shown;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    shown += OneLine(text.substr(0, end), kAnyWidth, keeps_utf8) + '\n';
    text.remove_prefix(end + 1);
  }
  return shown + OneLine(text, kAnyWidth, keeps_utf8);
}

std::size_t ColumnsOf(std::string_view line) {
  return static_cast<std::size_t>(std::ranges::count_if(
      line, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

bool TerminalReadsUtf8() {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nobody sets it
    if (value != nullptr && *value != '\0') {
      const std::string_view text(value);
      return text.find("UTF-8") != std::string_view::npos ||
             text.find("utf8") != std::string_view::npos;
    }
  }
  return false;
}

KeptValue KeptValue::Of(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) {
    return {.type = 'D', .number = *number, .size = sizeof(double)};
  }
  std::string_view bytes;
  if (const auto* text = std::get_if<std::string>(&value)) {
    bytes = *text;
  } else {
    const auto& binary = std::get<Binary>(value);
    bytes = {reinterpret_cast<const char*>(binary.data()), binary.size()};
  }
  return {.type = std::holds_alternative<Binary>(value) ? 'B' : 'S',
          .head = std::string(bytes.substr(0, kMostBytes)),
          .size = bytes.size(),
          .hash = std::hash<std::string_view>{}(bytes)};
}

KeptValue KeptValue::Shortened(std::size_t bytes) const {
  KeptValue shortened{
      .type = type, .number = number, .head = head.substr(0, bytes), .size = size, .hash = hash};
  return shortened;
}

std::string ShownValue(const KeptValue& value, std::size_t width, bool keeps_utf8) {
  switch (value.type) {
    case 'D':
      return OneLine(NumberText(value.number), width);
    case 'B':
      return BinaryText(value, width);
    case 'S':
      break;
    default:
      return "";
  }
  if (value.head.size() == value.size) {
    return OneLine(value.head, width, keeps_utf8);
  }
  const std::string size = fmt::format("[{}] ", ShownSize(value.size));
  return size + OneLine(value.head, width - std::min(width, size.size()), keeps_utf8);
}

std::string ShownSize(std::size_t bytes) {
  const auto size = static_cast<double>(bytes);
  if (bytes < 1000) {
    return fmt::format("{} B", bytes);
  }
  return size < 1e6 ? fmt::format("{:.1f} kB", size / 1e3) : fmt::format("{:.1f} MB", size / 1e6);
}

std::string ShownAge(Seconds age) {
  const double seconds = std::max(0.0, age.value());
  const auto whole = static_cast<std::int64_t>(std::min(seconds, 1e15));
  if (seconds < 99.95) {
    return fmt::format("{:.1f}", seconds);
  }
  if (whole < 6000) {
    return fmt::format("{}m{:02}", whole / 60, whole % 60);
  }
  if (whole < 360'000) {
    return fmt::format("{}h{:02}", whole / 3600, whole / 60 % 60);
  }
  const std::int64_t days = whole / 86400;
  return days < 1000 ? fmt::format("{}d{:02}", days, whole / 3600 % 24) : "old";
}

std::string ShownRate(double hz) {
  if (!(hz > 0.0)) {
    return "-";
  }
  if (hz < 0.0095) {
    return "<0.01";
  }
  return hz >= 99.5    ? fmt::format("{:.0f}", std::min(hz, 999'999.0))
         : hz >= 9.995 ? fmt::format("{:.1f}", hz)
                       : fmt::format("{:.2f}", hz);
}

}  // namespace limpet
