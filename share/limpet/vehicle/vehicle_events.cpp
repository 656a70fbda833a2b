// SPDX-License-Identifier: MIT
#include "limpet/vehicle/vehicle_events.hpp"

#include "limpet/core/require.hpp"

namespace limpet {

std::string_view EventName(VehicleEvent event) {
  switch (event) {
    case VehicleEvent::kSurfaced:
      return "surfaced";
    case VehicleEvent::kSubmerged:
      return "submerged";
    case VehicleEvent::kTouchedBottom:
      return "touched_bottom";
    case VehicleEvent::kLeftBottom:
      return "left_bottom";
  }
  return "";
}

EventMonitor::EventMonitor(const VehicleModel& model, const StateVector& x)
    : model_(&model),
      is_surfaced_(x(state_index::kPosition + 2) < model.params().submerged_depth_m),
      is_at_bottom_(model.Clearance(x) < model.params().touch_clearance_m) {}

std::array<double, EventMonitor::kGuards> EventMonitor::Guards(const StateVector& x,
                                                               bool with_seabed) const {
  const VehicleParams& params = model_->params();
  const double depth = x(state_index::kPosition + 2);
  const double surface =
      is_surfaced_ ? params.submerged_depth_m - depth : depth - params.surfaced_depth_m;
  if (!with_seabed) return {surface, 1.0};
  const double clearance = model_->Clearance(x);
  const double bottom =
      is_at_bottom_ ? params.leave_clearance_m - clearance : clearance - params.touch_clearance_m;
  return {surface, bottom};
}

VehicleEvent EventMonitor::Cross(int index) {
  LIMPET_REQUIRE(index == 0 || index == 1, "guard 0 is the surface, guard 1 the bottom");
  if (index == 0) {
    is_surfaced_ = !is_surfaced_;
    return is_surfaced_ ? VehicleEvent::kSurfaced : VehicleEvent::kSubmerged;
  }
  is_at_bottom_ = !is_at_bottom_;
  return is_at_bottom_ ? VehicleEvent::kTouchedBottom : VehicleEvent::kLeftBottom;
}

}  // namespace limpet
