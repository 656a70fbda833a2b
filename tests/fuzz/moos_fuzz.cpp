// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "limpet/mission/mission_file.hpp"
#include "limpet/mission/outside.hpp"
#include "tests/fuzz/time_bound.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const limpet::TimeBound bound(size);
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const limpet::MissionFile mission = limpet::ReadMission(text, "fuzz.moos", {});
    static_cast<void>(limpet::OutsideProblems(mission, {"."}));
    static_cast<void>(limpet::ParseMission(text, "fuzz.moos", {}));
  } catch (const limpet::ConfigError&) {
    return 0;  // a refusal is a fine answer
  }
  return 0;
}
