// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/expected.hpp"
#include "limpet/objects/frame.hpp"

namespace limpet {

/// One row per frame: frame,t,north,east,down,roll,pitch,yaw,altitude,boxes; boxes are
/// `u:v:w:h:confidence:color:landmark` joined by blanks; blanks, commas and colons of a color as
/// `%20`. Metres, radians, pixels; t is MOOS time.
[[nodiscard]] std::string FramesToCsv(const std::vector<ObservedFrame>& frames);
[[nodiscard]] Expected<std::vector<ObservedFrame>> FramesFromCsv(std::string_view text);

}  // namespace limpet
