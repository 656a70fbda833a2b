// SPDX-License-Identifier: MIT
// The files of a saved session, whatever they hold.
#include <cstddef>
#include <cstdint>
#include <string>

#include "limpet/session/session_memory.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const limpet::SessionFiles sound{{"objects.json", R"({"opis":[]})"}};
  for (const char* name : {"area.txt", "objects.json", "known_landmarks.json", "landmarks.json",
                           "frames.csv", "phases.csv", "depths.csv"}) {
    limpet::SessionFiles files = sound;
    files[name] = text;
    if (const auto memory = limpet::MemoryOf(files)) {
      static_cast<void>(limpet::PriorOf({}, *memory));
      static_cast<void>(limpet::PhaseOfFrames(*memory));
    }
  }
  return 0;
}
