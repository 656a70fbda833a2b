// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/core/units.hpp"
#include "limpet/energy/energy_prior.hpp"
#include "limpet/energy/way_power.hpp"
#include "limpet/topics/energy.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/topics/safety.hpp"

namespace limpet {

/// Where the vehicle is on its way home, and what has to be left there.
struct HomeLeg {
  Meters distance{0.0};
  Meters depth{0.0};
  Seconds at_surface{0.0};     ///< there, before the mission ends
  double reserve_share = 0.0;  ///< of a full battery
  double course = 0.0;         ///< [rad]
};

/// What is left in the battery and what the way home takes. It begins with the sheets and a margin,
/// and learns from what is used: energy per metre of way, power without way on, and how much a
/// share of the gauge's charge is worth. A current that is known counts by course: what a way took
/// is held against what the sheets say of it. Where the voltage says less than the gauge, the
/// voltage is believed: a gauge that sticks, or cells that are lost, show in it. Pure; times are
/// the listener's own.
class EnergyEstimate {
 public:
  EnergyEstimate(const VehicleParams& vehicle, const BatterySheet& battery);

  void Hear(const BatteryState& battery, Seconds now);
  /// REQUIRES: a usable state.
  void Hear(const NavState& nav, Seconds now);
  void Hear(const WaterCurrent& current) { current_ = current; }
  /// Absent before a battery was heard.
  [[nodiscard]] std::optional<EnergyState> At(const HomeLeg& home) const;
  /// Cost by course at the speed of the ways so far; without a current, or with one that makes no
  /// difference, none.
  [[nodiscard]] CourseCost CostsByCourse() const;

 private:
  /// Books what was used since the last BATTERY.
  void Book(double used_wh, Seconds duration);
  [[nodiscard]] double CapacityWh() const;
  /// There is a current that is told apart from none, and makes a difference.
  [[nodiscard]] bool HasCurrent() const;
  [[nodiscard]] MetersPerSecond Cruise() const;
  /// Energy that a metre of the way home takes at this course [Wh].
  [[nodiscard]] double HomeMetre(double course) const;
  /// The charge that voltage and current speak for; absent where they are not known.
  [[nodiscard]] std::optional<double> ChargeByVoltage(const BatteryState& battery) const;

  BatterySheet sheet_;
  EnergyPrior prior_;
  WayPower power_;
  std::optional<Stamped<BatteryState>> battery_;
  std::optional<Stamped<NavState>> nav_;
  std::optional<WaterCurrent> current_;
  double way_m_ = 0.0;  ///< since the last BATTERY
  /// Metres of still water that would have taken as much since the last BATTERY, by the sheets.
  double still_m_ = 0.0;
  std::optional<double> first_charge_;
  double used_wh_ = 0.0;
  /// Sums that begin with the prior's weight and forget.
  double moving_m_, moving_still_m_, moving_s_, moving_wh_, idle_s_, idle_wh_;
  /// Length [m] and energy [Wh] of the piece of way that is being flown, and the dearest metre of
  /// those before.
  double piece_m_ = 0.0, piece_wh_ = 0.0, dearest_metre_wh_ = 0.0;
  std::optional<double> gauge_excess_;  ///< smoothed
};

}  // namespace limpet
