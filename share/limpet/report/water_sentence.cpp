// SPDX-License-Identifier: MIT
#include "limpet/report/water_sentence.hpp"

#include <fmt/format.h>

namespace limpet {
namespace {

bool HasSeenNothing(const Coverage& believed) {
  return believed.seabed <= 0.0 && believed.band <= 0.0 && believed.band_top <= 0.0;
}

std::string InSight(const WaterScore& water) {
  if (water.seen_from_m <= 0.0) {
    return HasSeenNothing(water.believed)
               ? "no image showed any of the area: nothing was seen, nothing is inspected"
               : "the bottom was in sight";
  }
  if (water.believed.band_top <= 0.0) {
    return "too murky: nothing was in sight from where it flew, nothing is inspected";
  }
  return fmt::format(
      "too murky: seen from {:.1f} m above the bottom up only, what is lower is not "
      "inspected",
      water.seen_from_m);
}

}  // namespace

std::string WaterSentence(const WaterScore& water) {
  return fmt::format("visibility {:.1f} m, give or take {:.1f} m; {}",
                     water.visibility.visibility.value(), water.visibility.sd.value(),
                     InSight(water));
}

}  // namespace limpet
