// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/vehicle/vehicle_events.hpp"
#include "limpet/vehicle/vehicle_model.hpp"

namespace limpet {

/// Classical Runge-Kutta of fixed step: eight times as fast as CVODE, for Monte-Carlo. The model
/// must outlive it.
class Rk4Integrator {
 public:
  struct Options {
    double step_s = 0.01;  ///< longest step
  };
  Rk4Integrator(const VehicleModel& model, const StateVector& start, const Options& options);
  Rk4Integrator(const VehicleModel& model, const StateVector& start)
      : Rk4Integrator(model, start, Options{}) {}

  /// Moves `duration` on with thrusts wanted [N]; appends what happened, in order. Times of events
  /// are interpolated linearly within a step.
  void Advance(const ThrusterVector& wanted_thrust, double duration,
               std::vector<TimedEvent>& events);
  [[nodiscard]] const StateVector& state() const { return x_; }
  [[nodiscard]] double time() const { return time_; }
  /// A fixed step cannot fail.
  [[nodiscard]] int failures() const { return 0; }

 private:
  void Step(const ThrusterVector& wanted_thrust, double h, bool with_seabed);

  const VehicleModel* model_;
  Options options_;
  StateVector x_;
  double time_ = 0.0;
  EventMonitor monitor_;
};

}  // namespace limpet
