// SPDX-License-Identifier: MIT
#include "apps/pHelm/stock_nav.hpp"

#include <algorithm>

#include "limpet/core/frames.hpp"

namespace limpet {

bool StockNav::IsComplete(bool needs_depth) const {
  return Of(Quantity::kX) && Of(Quantity::kY) && Of(Quantity::kHeading) && Of(Quantity::kSpeed) &&
         (!needs_depth || Of(Quantity::kDepth));
}

std::optional<NavState> StockNav::At(Seconds now, Seconds grace, bool needs_depth) const {
  if (!IsComplete(needs_depth)) return std::nullopt;
  const auto is_fresh = [&](Quantity quantity) {
    const std::optional<Stamped<double>>& heard = Of(quantity);
    return heard && now - heard->time <= grace;
  };
  const auto is_needed_fresh = [&](Quantity quantity) {
    return is_fresh(quantity) || (quantity == Quantity::kDepth && !needs_depth);
  };
  constexpr std::array kNeeded{Quantity::kX, Quantity::kY, Quantity::kHeading, Quantity::kSpeed,
                               Quantity::kDepth};
  if (!std::ranges::all_of(kNeeded, is_needed_fresh)) return std::nullopt;
  NavState nav;
  nav.north = Of(Quantity::kY)->value;
  nav.east = Of(Quantity::kX)->value;
  nav.down = is_fresh(Quantity::kDepth) ? Of(Quantity::kDepth)->value : 0.0;
  nav.yaw = YawFromMoosHeading(Of(Quantity::kHeading)->value);
  nav.u = Of(Quantity::kSpeed)->value;
  if (is_fresh(Quantity::kAltitude)) nav.altitude = Of(Quantity::kAltitude)->value;
  return nav;
}

}  // namespace limpet
