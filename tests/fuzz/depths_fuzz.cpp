// SPDX-License-Identifier: MIT
// The depths of a saved session, whatever they hold.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "estimation/mapping/depth_map.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto depths = limpet::DepthMap::Parse(text)) {
    static_cast<void>(depths->Columns());
    const auto again = limpet::DepthMap::Parse(depths->Serialize());
    if (!again || again->Serialize() != depths->Serialize()) {
      std::abort();  // what was read and saved must be read again as it was
    }
  }
  return 0;
}
