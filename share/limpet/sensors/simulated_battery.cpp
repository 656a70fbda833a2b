// SPDX-License-Identifier: MIT
#include "limpet/sensors/simulated_battery.hpp"

#include <algorithm>

#include "limpet/mission/fault_names.hpp"

namespace limpet {
namespace {

/// Noise of a gauge's readings, 1-sigma: volts, and a share of the amperes.
constexpr double kVoltsNoise = 0.02, kAmperesNoise = 0.01;
constexpr double kWorst = 3.0;  ///< sigmas: no battery is off by more

BatterySheet TrueBattery(BatterySheet sheet, const BatteryErrorParams& errors, Random& random) {
  const double off = std::clamp(random.Normal(sheet.capacity_sigma), -kWorst * sheet.capacity_sigma,
                                kWorst * sheet.capacity_sigma);
  sheet.capacity_wh *= errors.capacity_factor * std::max(0.1, 1.0 + off);
  sheet.resistance_ohm *= errors.resistance_factor;
  sheet.hotel_w *= errors.hotel_factor;
  sheet.full_thrust_w *= errors.thrust_power_factor;
  return sheet;
}

}  // namespace

SimulatedBattery::SimulatedBattery(const BatterySheet& sheet, const BatteryErrorParams& errors,
                                   Random random, std::optional<double> charge)
    : sheet_(TrueBattery(sheet, errors, random)),
      errors_(errors),
      noise_(random),
      gauge_off_(errors.gauge_off + noise_.Normal(sheet.gauge_sigma)),
      battery_(sheet_, charge.value_or(errors.charge)) {}

void SimulatedBattery::Draw(const ThrusterVector& thrust, Seconds duration,
                            const FaultSchedule& faults) {
  double power_w = sheet_.hotel_w;
  for (const double one : thrust) {
    power_w += sheet_.ThrusterPower(one);
  }
  if (const ScenarioFault* load = faults.Active(fault_names::kBatteryLoad)) power_w += load->size;
  const ScenarioFault* lost = faults.Active(fault_names::kCellsLost);
  battery_.LoseCells(lost != nullptr ? lost->size : 0.0);
  battery_.Draw(power_w, duration);
}

BatteryState SimulatedBattery::Gauge(const FaultSchedule& faults) {
  const double read = std::clamp(battery_.charge() + gauge_off_, 0.0, 1.0);
  stuck_at_ = faults.Active(fault_names::kGaugeStuck) != nullptr ? stuck_at_.value_or(read)
                                                                 : std::optional<double>();
  const ScenarioFault* said = faults.Active(fault_names::kBattery);
  const double share = said != nullptr ? said->size : stuck_at_.value_or(read);
  const double volts = is_off() ? 0.0 : battery_.volts() + noise_.Normal(kVoltsNoise);
  return {.charge = share,
          .volts = std::max(0.0, volts),
          .amperes = battery_.amperes() * (1.0 + noise_.Normal(kAmperesNoise))};
}

SimBattery SimulatedBattery::Truth() const {
  return {.charge = battery_.charge(),
          .capacity_wh = sheet_.capacity_wh,
          .used_wh = battery_.used_wh(),
          .is_off = battery_.is_off()};
}

}  // namespace limpet
