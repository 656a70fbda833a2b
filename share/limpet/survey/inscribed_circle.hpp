// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/survey/simple_polygon.hpp"

namespace limpet {

/// Radius of the greatest circle inside a polygon [m], to 2 % or a centimetre: half its width where
/// it is widest.
[[nodiscard]] double InscribedRadius(const SimplePolygon& polygon);

}  // namespace limpet
