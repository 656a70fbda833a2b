// SPDX-License-Identifier: MIT
#include "limpet/launch/surfacing.hpp"

#include <utility>

namespace limpet {

void Surfacing::Begin(std::string why, Seconds moos_now) {
  why_ = std::move(why);
  began_ = moos_now;
}

bool Surfacing::EndsNow(const Signs& signs, Seconds moos_now) {
  if (!is_under_way()) {
    return false;
  }
  const Seconds passed = moos_now - *began_;
  const bool is_up = passed > kAtLeast && signs.depth_m && *signs.depth_m < kSurfaceDepth_m;
  has_ended_ = !signs.was_deployed || is_up || passed > kLongest;
  return has_ended_;
}

}  // namespace limpet
