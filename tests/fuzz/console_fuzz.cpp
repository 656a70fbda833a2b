// SPDX-License-Identifier: MIT
// Any bytes as what a community says, what a person types, and what is poked: nothing of it may
// reach the terminal as anything but plain text of the width that was asked for.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "limpet/console/community_status.hpp"
#include "limpet/console/key_reader.hpp"
#include "limpet/console/poke.hpp"
#include "limpet/console/shown_text.hpp"

namespace {

void Check(std::string_view line, std::size_t width) {
  if (limpet::ColumnsOf(line) > width) {
    std::abort();
  }
  for (const char c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      std::abort();
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const std::size_t width : {std::size_t{0}, std::size_t{9}, std::size_t{80}, size * 8}) {
    Check(limpet::OneLine(text, width, size % 2 == 0), width);
  }
  if (const auto poke = limpet::ParsePoke(text, limpet::Seconds(1.0))) {
    Check(poke->name, 1024);
  }
  static_cast<void>(limpet::KeyReader().Feed(text));
  limpet::CommunityStatus status;
  for (const char* name : {"PROC_SUMMARY", "DB_QOS", "PLAUNCH_STATUS", "X_WARNINGS"}) {
    limpet::Message message;
    message.name = name;
    message.value = std::string(text);
    status.Hear(message);
  }
  for (const limpet::FrameLine& line : limpet::StatusTable(status.Rows())) {
    Check(line.PlainText(), limpet::kAnyWidth);
  }
  return 0;
}
