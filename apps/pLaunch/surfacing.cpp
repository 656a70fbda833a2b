// SPDX-License-Identifier: MIT
#include "apps/pLaunch/surfacing.hpp"

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
  has_ended_ = !signs.was_deployed || (signs.depth_m && *signs.depth_m < kSurfaceDepth_m) ||
               moos_now - *began_ > kLongest;
  return has_ended_;
}

}  // namespace limpet
