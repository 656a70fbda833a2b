// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "limpet/logbook/alog_escape.hpp"
#include "limpet/logbook/alog_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  limpet::AlogReader reader = limpet::AlogReader::OfText(text);
  for (limpet::AlogEntry entry; reader.Next(entry);) {
    static_cast<void>(limpet::ParseBlogMarker(entry.value));
  }
  std::string escaped;
  std::string back;
  limpet::AppendEscaped(escaped, text);
  limpet::AppendUnescaped(back, escaped);
  if (back != text || escaped.find('\n') != std::string::npos) {
    std::abort();
  }
  return 0;
}
