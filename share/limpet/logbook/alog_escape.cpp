// SPDX-License-Identifier: MIT
#include "limpet/logbook/alog_escape.hpp"

namespace limpet {
namespace {

constexpr std::string_view kEscaped{"\n\r\\\0", 4};

char CodeOf(char plain) {
  return plain == '\n' ? 'n' : plain == '\r' ? 'r' : plain == '\0' ? '0' : '\\';
}

}  // namespace

void AppendEscaped(std::string& out, std::string_view text) {
  if (text.starts_with(' ') || text.starts_with('\t')) {
    out += '\\';
  }
  while (!text.empty()) {
    const std::size_t plain = text.find_first_of(kEscaped);
    out += text.substr(0, plain);
    if (plain == std::string_view::npos) {
      return;
    }
    out += '\\';
    out += CodeOf(text[plain]);
    text.remove_prefix(plain + 1);
  }
}

void AppendUnescaped(std::string& out, std::string_view text) {
  while (!text.empty()) {
    const std::size_t plain = text.find('\\');
    out += text.substr(0, plain);
    if (plain == std::string_view::npos) {
      return;
    }
    const char code = plain + 1 < text.size() ? text[plain + 1] : '\0';
    switch (code) {
      case 'n':
        out += '\n';
        break;
      case 'r':
        out += '\r';
        break;
      case '0':
        out += '\0';
        break;
      case '\\':
      case ' ':
      case '\t':
        out += code;
        break;
      default:
        out += text.substr(plain, 2);
        break;
    }
    text.remove_prefix(code == '\0' && plain + 1 >= text.size() ? plain + 1 : plain + 2);
  }
}

}  // namespace limpet
