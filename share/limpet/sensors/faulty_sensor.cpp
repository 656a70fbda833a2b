// SPDX-License-Identifier: MIT
#include "limpet/sensors/faulty_sensor.hpp"

#include <numbers>

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
void GarbleSome(Sample& sample, const char* what, const FaultSchedule& faults, Random& random) {
  const ScenarioFault* outliers = faults.Active(what);
  if (outliers != nullptr && random.Uniform(0.0, 1.0) < outliers->size) Garble(sample, random);
}

}  // namespace

std::optional<ImuSample> FaultyImu::Pass(ImuSample sample, const FaultSchedule& faults) {
  GarbleSome(sample, "imu_outliers", faults, random_);
  return any_.Pass(sample, faults);
}

std::optional<DvlSample> FaultyDvl::Pass(DvlSample sample, const FaultSchedule& faults) {
  if (faults.Active("dvl_no_lock") != nullptr) return DvlSample{};
  if (faults.Active("dvl_flipped") != nullptr) {
    Flip(sample.u);
    Flip(sample.v);
  }
  if (const ScenarioFault* biased = faults.Active("dvl_biased")) Shift(sample.u, biased->size);
  GarbleSome(sample, "dvl_outliers", faults, random_);
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
