// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "limpet/objects/status_posterior.hpp"

namespace limpet {

/// What a decided status looks like in every picture; of Okabe and Ito's colours, which the
/// colour-blind tell apart.
struct StatusColor {
  std::string_view hex;   ///< for SVG: #rrggbb
  std::string_view moos;  ///< for MOOS's viewers: the nearest name that they know
  std::uint8_t red = 0, green = 0, blue = 0;
};
/// Nothing for what is not decided: each picture shows that by what stands out against its ground.
[[nodiscard]] std::optional<StatusColor> ColorOf(Status status);

}  // namespace limpet
