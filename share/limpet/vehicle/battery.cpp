// SPDX-License-Identifier: MIT
#include "limpet/vehicle/battery.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/require.hpp"

namespace limpet {

void Battery::Draw(double power_w, Seconds duration) {
  LIMPET_REQUIRE(power_w >= 0.0 && duration >= Seconds(0.0), "a battery is not charged here");
  if (is_off_) return;
  const double open_v = cells_ * sheet_.OpenCircuitVolts(charge_);
  // power = volts * (open - volts) / resistance: the greater root; none, if it cannot give that.
  const double rest = open_v * open_v - 4.0 * Resistance() * power_w;
  volts_ = rest > 0.0 ? 0.5 * (open_v + std::sqrt(rest)) : 0.0;
  if (charge_ <= 0.0 || volts_ <= sheet_.empty_v) {
    is_off_ = true;
    volts_ = 0.0;
    amperes_ = 0.0;
    return;
  }
  amperes_ = power_w / volts_;
  const double seconds = duration.value();
  used_wh_ += power_w * seconds / kJoulesPerWh;
  // The cells give at their open-circuit voltage; their resistance takes a share of that.
  const double drawn_wh = amperes_ * open_v * seconds / kJoulesPerWh;
  charge_ = std::max(0.0, charge_ - drawn_wh / (cells_ * sheet_.capacity_wh));
}

}  // namespace limpet
