// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <string>

#include "limpet/tuning/live_setting.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (const auto event = limpet::LiveEvent::FromText(text)) {
    static_cast<void>(limpet::LiveEvent::FromText(event->Text()));
  }
  static_cast<void>(limpet::UpdateCountIn(text, "cover"));
  static_cast<void>(limpet::UpdatedValue(text, "cover", "pwt"));
  return 0;
}
