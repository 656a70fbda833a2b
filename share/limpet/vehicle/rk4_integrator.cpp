// SPDX-License-Identifier: MIT
#include "limpet/vehicle/rk4_integrator.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace limpet {

Rk4Integrator::Rk4Integrator(const VehicleModel& model, const StateVector& start,
                             const Options& options)
    : model_(&model), options_(options), x_(start), monitor_(model, start) {}

void Rk4Integrator::Step(const ThrusterVector& wanted_thrust, double h, bool with_seabed) {
  const StateVector k1 = model_->Derivative(x_, wanted_thrust, with_seabed);
  const StateVector k2 = model_->Derivative(x_ + 0.5 * h * k1, wanted_thrust, with_seabed);
  const StateVector k3 = model_->Derivative(x_ + 0.5 * h * k2, wanted_thrust, with_seabed);
  const StateVector k4 = model_->Derivative(x_ + h * k3, wanted_thrust, with_seabed);
  x_ += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
}

void Rk4Integrator::Advance(const ThrusterVector& wanted_thrust, double duration,
                            std::vector<TimedEvent>& events) {
  // MOOS time resolves 0.2 microseconds: a whole number of steps must not gain one by rounding.
  const double count = std::max(1.0, std::ceil(duration / options_.step_s - 1e-3));
  const double h = duration / count;
  const double begin = time_;
  const bool with_seabed = model_->IsNearSeabed(x_, duration);
  auto before = monitor_.Guards(x_, with_seabed);
  for (int step = 1; step <= static_cast<int>(count); ++step) {
    Step(wanted_thrust, h, with_seabed);
    const auto after = monitor_.Guards(x_, with_seabed);
    for (std::size_t i = 0; i < after.size(); ++i) {
      if (after[i] > 0.0) continue;
      const double share = before[i] / (before[i] - after[i]);
      events.push_back({Seconds(time_ + share * h), monitor_.Cross(static_cast<int>(i))});
    }
    time_ = begin + step * h;
    before = monitor_.Guards(x_, with_seabed);
  }
}

}  // namespace limpet
