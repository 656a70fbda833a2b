// SPDX-License-Identifier: MIT
#include "apps/uSimSensors/faulty_sensor.hpp"

namespace limpet {
namespace {

void Flip(std::optional<double>& velocity) {
  if (velocity) velocity = -*velocity;
}

void Shift(std::optional<double>& value, double by) {
  if (value) *value += by;
}

}  // namespace

std::optional<DvlSample> FaultyDvl::Pass(DvlSample sample, const FaultSchedule& faults) {
  if (faults.Active("dvl_no_lock") != nullptr) return DvlSample{};
  if (faults.Active("dvl_flipped") != nullptr) {
    Flip(sample.u);
    Flip(sample.v);
  }
  if (const ScenarioFault* biased = faults.Active("dvl_biased")) Shift(sample.u, biased->size);
  if (const ScenarioFault* biased = faults.Active("altitude_biased")) {
    Shift(sample.altitude, biased->size);
  }
  if (faults.Active("altitude_stuck") == nullptr) {
    altitude_ = sample.altitude;
  } else {
    sample.altitude = altitude_ = altitude_ ? altitude_ : sample.altitude;
  }
  return any_.Pass(sample, faults);
}

double WithDepthFault(double depth_m, const FaultSchedule& faults) {
  const ScenarioFault* biased = faults.Active("depth_biased");
  return biased != nullptr ? depth_m + biased->size : depth_m;
}

GpsFix WithGpsFault(GpsFix fix, const FaultSchedule& faults) {
  if (const ScenarioFault* jump = faults.Active("gps_jump")) fix.north += jump->size;
  return fix;
}

}  // namespace limpet
