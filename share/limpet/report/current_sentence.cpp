// SPDX-License-Identifier: MIT
#include "limpet/report/current_sentence.hpp"

#include <cmath>

#include <fmt/format.h>

#include "limpet/core/frames.hpp"

namespace limpet {

std::string CurrentSentence(const WaterCurrent& current) {
  const double sets_to_deg = MoosHeadingFromYaw(std::atan2(current.east, current.north));
  return fmt::format("{:.2f} m/s, sets to {:03} deg, give or take {:.2f} m/s",
                     std::hypot(current.north, current.east), std::lround(sets_to_deg) % 360,
                     current.sd);
}

}  // namespace limpet
