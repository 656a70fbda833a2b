// SPDX-License-Identifier: MIT
#include "limpet/core/harmless_text.hpp"

#include <cstddef>
#include <cstdint>

#include <fmt/format.h>

namespace limpet {
namespace {

struct Utf8Character {
  std::uint32_t code = 0;
  std::size_t length = 0;  ///< 0: the bytes are none
};

Utf8Character FirstOf(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  const std::size_t length = lead < 0x80   ? 1
                             : lead < 0xC2 ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
  if (length == 0 || text.size() < length) return {};
  std::uint32_t code = length == 1 ? lead : lead & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {};
    code = (code << 6U) | (byte(i) & 0x3FU);
  }
  const bool is_overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool is_none = is_overlong || (code >= 0xD800 && code < 0xE000) || code > 0x10FFFF;
  return is_none ? Utf8Character{} : Utf8Character{code, length};
}

bool IsObeyed(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x061C ||
         (code >= 0x200B && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) ||
         (code >= 0x2060 && code <= 0x206F) || code == 0xFEFF;
}

}  // namespace

std::string HarmlessText(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const Utf8Character character = FirstOf(text);
    const std::size_t length = character.length == 0 ? 1 : character.length;
    if (character.length == 0) {
      shown += fmt::format("\\x{:02x}", static_cast<unsigned>(static_cast<unsigned char>(text[0])));
    } else if (!IsObeyed(character.code)) {
      shown += text.substr(0, length);
    } else if (text[0] == '\n' || text[0] == '\r' || text[0] == '\t') {
      shown += text[0] == '\n' ? "\\n" : text[0] == '\r' ? "\\r" : "\\t";
    } else {
      shown += character.code < 0x80 ? fmt::format("\\x{:02x}", character.code)
                                     : fmt::format("\\u{:04x}", character.code);
    }
    text.remove_prefix(length);
  }
  return shown;
}

}  // namespace limpet
