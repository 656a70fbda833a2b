// SPDX-License-Identifier: MIT
#include "limpet/session/class_text.hpp"

#include <fmt/format.h>

namespace limpet {

std::string ClassText(std::string_view name) {
  std::string text;
  for (const char c : name) {
    const bool ends_a_field = static_cast<unsigned char>(c) <= ' ' || c == ',' || c == ':';
    text += ends_a_field || c == '%' ? fmt::format("%{:02x}", static_cast<unsigned char>(c))
                                     : std::string(1, c);
  }
  return text;
}

std::string ClassFrom(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t high = i + 2 < text.size() ? kDigits.find(text[i + 1]) : kDigits.npos;
    const std::size_t low = high != kDigits.npos ? kDigits.find(text[i + 2]) : kDigits.npos;
    const bool is_coded = text[i] == '%' && low != kDigits.npos;
    name += is_coded ? static_cast<char>(16 * high + low) : text[i];
    i += is_coded ? 2 : 0;
  }
  return name;
}

}  // namespace limpet
