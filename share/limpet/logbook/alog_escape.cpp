// SPDX-License-Identifier: MIT
#include "limpet/logbook/alog_escape.hpp"

namespace limpet {

void AppendEscaped(std::string& out, std::string_view text) {
  if (text.starts_with(' ') || text.starts_with('\t')) {
    out += '\\';
  }
  while (!text.empty()) {
    const std::size_t plain = text.find_first_of("\n\r\\");
    out += text.substr(0, plain);
    if (plain == std::string_view::npos) {
      return;
    }
    out += '\\';
    out += text[plain] == '\n' ? 'n' : text[plain] == '\r' ? 'r' : '\\';
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
