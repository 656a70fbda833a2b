// SPDX-License-Identifier: MIT
#include "limpet/sensors/faulty_sensor.hpp"

#include <numbers>
#include <string_view>

#include "limpet/mission/fault_names.hpp"

namespace limpet {
namespace {

void Flip(std::optional<double>& velocity) {
  if (velocity) velocity = -*velocity;
}

void Shift(std::optional<double>& value, double by) {
  if (value) *value += by;
}

/// A sample of which the line has made anything.
void Garble(ImuSample& sample, Random& random) {
  constexpr double kRate = 4.0, kForce = 40.0;  // [rad/s], [m/s^2]
  for (double* rate : {&sample.p, &sample.q, &sample.r})
    *rate = random.Uniform(-kRate, kRate);
  for (double* force : {&sample.fx, &sample.fy, &sample.fz})
    *force = random.Uniform(-kForce, kForce);
  sample.heading = random.Uniform(-std::numbers::pi, std::numbers::pi);
}

void Garble(DvlSample& sample, Random& random) {
  constexpr double kVelocityGlitch = 5.0;  // [m/s]
  for (std::optional<double>* velocity : {&sample.u, &sample.v, &sample.w})
    Shift(*velocity, random.Uniform(-kVelocityGlitch, kVelocityGlitch));
}

template <class Sample>
void GarbleSome(Sample& sample, std::string_view what, const FaultSchedule& faults,
                Random& random) {
  const ScenarioFault* outliers = faults.Active(what);
  if (outliers != nullptr && random.Uniform(0.0, 1.0) < outliers->size) Garble(sample, random);
}

}  // namespace

std::optional<ImuSample> FaultyImu::Pass(ImuSample sample, const FaultSchedule& faults) {
  GarbleSome(sample, fault_names::kImuOutliers, faults, random_);
  return any_.Pass(sample, faults);
}

std::optional<DvlSample> FaultyDvl::Pass(DvlSample sample, const FaultSchedule& faults) {
  if (faults.Active(fault_names::kDvlNoLock) != nullptr) return DvlSample{};
  if (faults.Active(fault_names::kDvlFlipped) != nullptr) {
    Flip(sample.u);
    Flip(sample.v);
  }
  if (const ScenarioFault* biased = faults.Active(fault_names::kDvlBiased))
    Shift(sample.u, biased->size);
  GarbleSome(sample, fault_names::kDvlOutliers, faults, random_);
  if (const ScenarioFault* biased = faults.Active(fault_names::kAltitudeBiased)) {
    Shift(sample.altitude, biased->size);
  }
  if (faults.Active(fault_names::kAltitudeStuck) == nullptr) {
    altitude_ = sample.altitude;
  } else {
    sample.altitude = altitude_ = altitude_ ? altitude_ : sample.altitude;
  }
  return any_.Pass(sample, faults);
}

double WithDepthFault(double depth_m, const FaultSchedule& faults) {
  const ScenarioFault* biased = faults.Active(fault_names::kDepthBiased);
  return biased != nullptr ? depth_m + biased->size : depth_m;
}

GpsFix WithGpsFault(GpsFix fix, const FaultSchedule& faults) {
  if (const ScenarioFault* jump = faults.Active(fault_names::kGpsJump)) fix.north += jump->size;
  return fix;
}

}  // namespace limpet
