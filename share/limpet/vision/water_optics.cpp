// SPDX-License-Identifier: MIT
#include "limpet/vision/water_optics.hpp"

#include <cmath>

#include "limpet/core/require.hpp"

namespace limpet {

WaterOptics WaterOptics::OfVisibility(double visibility_m) {
  LIMPET_REQUIRE(visibility_m > 0.0, "visibility must be positive");
  const double green = -std::log(kContrastAtVisibility) / visibility_m;
  // What red and blue lose beyond green in coastal water [1/m].
  constexpr double kExtraRed = 0.12;
  constexpr double kExtraBlue = 0.03;
  WaterOptics optics;
  optics.attenuation_per_m = {green + kExtraBlue, green, green + kExtraRed};
  return optics;
}

}  // namespace limpet
