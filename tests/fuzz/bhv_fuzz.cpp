// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "limpet/mission/mode_set.hpp"
#include "tests/fuzz/time_bound.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const limpet::TimeBound bound(size);
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    limpet::BehaviorFile file = limpet::ParseBehaviors(text, "fuzz.bhv", {});
    limpet::ModeSet modes(std::move(file.modes));
    const auto nothing = [](std::string_view) -> const limpet::Value* { return nullptr; };
    static_cast<void>(modes.Evaluate(nothing, limpet::Seconds(0.0)));
    static_cast<void>(modes.Summary());
  } catch (const limpet::ConfigError&) {
    return 0;  // a refusal is a fine answer
  }
  return 0;
}
