// SPDX-License-Identifier: MIT
#include "limpet/survey/band_top.hpp"

#include <fmt/format.h>

namespace limpet {

std::optional<std::string> ProblemOf(const BandView& view, std::string_view altitude_named) {
  const double above = view.object_height_max > 0.0 ? view.object_radius : 0.0;
  const double top = view.object_height_max + above;
  if (top < view.altitude) return std::nullopt;
  return fmt::format(
      "objects may reach {:g} m above the seabed, and the vehicle flies at {}; allowed: below {:g} "
      "m",
      top, altitude_named, view.altitude - above);
}

}  // namespace limpet
