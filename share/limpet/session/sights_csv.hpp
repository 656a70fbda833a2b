// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/objects/frame.hpp"

namespace limpet {

/// One row per frame: frame,t,north,east,down,roll,pitch,yaw,altitude,boxes; boxes are
/// `u:v:w:h:confidence:color:landmark` joined by blanks. Metres, radians, pixels; t is MOOS time.
[[nodiscard]] std::string SightsToCsv(const std::vector<ObservedFrame>& sights);
[[nodiscard]] Expected<std::vector<ObservedFrame>> SightsFromCsv(std::string_view text);

}  // namespace limpet
