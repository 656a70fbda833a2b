// SPDX-License-Identifier: MIT
// Any message that pLog could be sent: what it writes is one line, and reads back as what it was.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "limpet/logbook/alog_format.hpp"
#include "limpet/logbook/alog_reader.hpp"

namespace {

void Require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

/// Up to `separator`, which goes too.
std::string Take(std::string_view& text, char separator) {
  const std::size_t end = text.find(separator);
  const std::string part(text.substr(0, end));
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return part;
}

void WriteAndRead(const limpet::Message& message, bool marks_types) {
  const limpet::AlogFormat format(limpet::Seconds(0.0),
                                  {.has_source_aux = true, .marks_data_type = marks_types});
  std::string log;
  format.AppendBanner(log, "fuzz.alog");
  const std::size_t begin = log.size();
  format.AppendLine(log, message);
  Require(log.find('\n', begin) == log.size() - 1);
  limpet::AlogReader reader = limpet::AlogReader::OfText(log);
  limpet::AlogEntry entry;
  Require(reader.Next(entry) && reader.skipped_lines() == 0);
  const std::string& text = std::get<std::string>(message.value);
  // Unmarked, a string that looks like a number reads as one; but never as another text.
  Require(entry.value == text || (!marks_types && entry.number && text.starts_with(entry.value)));
  Require(!reader.Next(entry) && !reader.has_torn_end());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view text(reinterpret_cast<const char*>(data), size);
  limpet::Message message{.name = Take(text, ';'),
                          .value = 0.0,
                          .time = limpet::Seconds(1.5),
                          .source = Take(text, ';'),
                          .source_aux = Take(text, ';'),
                          .community = ""};
  message.value = std::string(text);
  WriteAndRead(message, false);
  WriteAndRead(message, true);
  return 0;
}
