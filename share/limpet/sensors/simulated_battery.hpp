// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/core/random.hpp"
#include "limpet/mission/fault_schedule.hpp"
#include "limpet/simulation/battery_error.hpp"
#include "limpet/topics/safety.hpp"
#include "limpet/topics/simulation.hpp"
#include "limpet/vehicle/battery.hpp"
#include "limpet/vehicle/thruster_layout.hpp"

namespace limpet {

/// The battery of a simulated vehicle as it truly is, and its gauge, which says something else.
class SimulatedBattery {
 public:
  /// `charge`: left from a former life of the process; absent: as the scenario says.
  SimulatedBattery(const BatterySheet& sheet, const BatteryErrorParams& errors, Random random,
                   std::optional<double> charge = {});

  /// Thrusters as they push, each -1 to 1, and all else draw on it for `duration`.
  void Draw(const ThrusterVector& thrust, Seconds duration, const FaultSchedule& faults);
  [[nodiscard]] bool is_off() const { return battery_.is_off(); }
  /// What its gauge says, whose charge may stick.
  [[nodiscard]] BatteryState Gauge(const FaultSchedule& faults);
  [[nodiscard]] SimBattery Truth() const;

 private:
  BatterySheet sheet_;  ///< as it truly is
  BatteryErrorParams errors_;
  Random noise_;
  double gauge_off_;
  Battery battery_;
  std::optional<double> stuck_at_;
};

}  // namespace limpet
