// SPDX-License-Identifier: MIT
#include "limpet/report/energy_sentence.hpp"

#include <fmt/format.h>

namespace limpet {

std::string EnergySentence(const EnergyRecord& energy) {
  const EnergyState& last = energy.last;
  return fmt::format(
      "used {:.0f} Wh, the way home was to take about {:.0f} Wh with the wait at the surface, "
      "{:.0f} Wh left ({:.0f} % of {:.0f} Wh)",
      last.used_wh, energy.home_wh, last.left_wh, 100.0 * last.charge, last.capacity_wh);
}

}  // namespace limpet
