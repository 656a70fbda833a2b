// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "limpet/mission/flag.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  static const limpet::Value number = 1.0;
  static const limpet::Value word = std::string("a:b");
  const auto lookup = [](std::string_view name) { return name.size() % 2 == 0 ? &number : &word; };
  if (const auto condition = limpet::Condition::Parse(text)) {
    limpet::Condition copy = *condition;
    static_cast<void>(copy.Holds(lookup, limpet::Seconds(0.0)));
    static_cast<void>(copy.Variables());
  }
  if (const auto flag = limpet::Flag::Parse(text)) {
    static_cast<void>(flag->Resolve([](std::string_view name) { return std::string(name); }));
  }
  return 0;
}
