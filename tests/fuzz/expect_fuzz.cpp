// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <string>

#include "limpet/mission/expectations.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    static_cast<void>(limpet::ParseExpectations(text, "fuzz.yaml", {"discovery", "change"}));
  } catch (const limpet::ConfigError&) {
    return 0;  // a refusal is a fine answer
  }
  return 0;
}
