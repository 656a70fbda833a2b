// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/units.hpp"
#include "limpet/vehicle/battery_sheet.hpp"

namespace limpet {

/// A battery under load: an open-circuit voltage by charge behind an internal resistance. What
/// draws on it takes its power at any voltage, so a sagging battery gives more current; when the
/// voltage under load falls to that of an empty one, its protection switches it off for good.
class Battery {
 public:
  /// REQUIRES: full_v above empty_v. `charge`: to begin with, share of a full one.
  Battery(const BatterySheet& sheet, double charge) : sheet_(sheet), charge_(charge) {}

  /// Draws `power_w` for `duration`. REQUIRES: neither is negative.
  void Draw(double power_w, Seconds duration);
  /// A share of its cells in series is shorted: that of voltage and energy is gone.
  void LoseCells(double share) { cells_ = 1.0 - share; }

  [[nodiscard]] double charge() const { return charge_; }
  /// Voltage at the battery's terminals, under the last load; 0 once it is off.
  [[nodiscard]] double volts() const { return volts_; }
  [[nodiscard]] double amperes() const { return amperes_; }
  [[nodiscard]] double used_wh() const { return used_wh_; }  ///< given at its terminals
  [[nodiscard]] bool is_off() const { return is_off_; }

 private:
  [[nodiscard]] double Resistance() const { return cells_ * sheet_.resistance_ohm; }

  BatterySheet sheet_;
  double charge_;
  double cells_ = 1.0;
  double volts_ = sheet_.OpenCircuitVolts(charge_), amperes_ = 0.0;
  double used_wh_ = 0.0;
  bool is_off_ = false;
};

}  // namespace limpet
