// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

#include "limpet/core/units.hpp"
#include "limpet/vehicle/vehicle_model.hpp"

namespace limpet {

enum class VehicleEvent { kSurfaced, kSubmerged, kTouchedBottom, kLeftBottom };

/// The word that SIM_EVENT carries.
[[nodiscard]] std::string_view EventName(VehicleEvent event);

struct TimedEvent {
  Seconds since_start;
  VehicleEvent event = VehicleEvent::kSurfaced;
};

/// Surface and bottom events with hysteresis. Each guard is positive while its present condition
/// holds and crosses zero where the other begins; the two thresholds of a guard lie apart, and
/// neither where the vehicle floats or rests, so a root finder never sits on a root.
class EventMonitor {
 public:
  static constexpr int kGuards = 2;
  /// Conditions from the state alone.
  EventMonitor(const VehicleModel& model, const StateVector& x);

  /// Without `with_seabed` the bottom guard is left out (positive): the seabed is far.
  [[nodiscard]] std::array<double, kGuards> Guards(const StateVector& x, bool with_seabed) const;
  /// Crosses guard `index` to the other condition.
  VehicleEvent Cross(int index);

 private:
  const VehicleModel* model_;
  bool is_surfaced_;
  bool is_at_bottom_;
};

}  // namespace limpet
