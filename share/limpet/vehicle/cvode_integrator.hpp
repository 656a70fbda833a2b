// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "limpet/vehicle/vehicle_events.hpp"
#include "limpet/vehicle/vehicle_model.hpp"

namespace limpet {

/// SUNDIALS CVODE, Adams with fixed-point iteration and root finding: the truth. Restarts at each
/// change of command, which is a discontinuity; without that it loses accuracy and may fail. The
/// model must outlive it.
class CvodeIntegrator {
 public:
  struct Options {
    double relative_tolerance = 1e-8;
    double absolute_tolerance = 1e-8;
  };
  CvodeIntegrator(const VehicleModel& model, const StateVector& start, const Options& options);
  CvodeIntegrator(const VehicleModel& model, const StateVector& start)
      : CvodeIntegrator(model, start, Options{}) {}
  ~CvodeIntegrator();
  CvodeIntegrator(const CvodeIntegrator&) = delete;
  CvodeIntegrator& operator=(const CvodeIntegrator&) = delete;
  CvodeIntegrator(CvodeIntegrator&&) noexcept;
  CvodeIntegrator& operator=(CvodeIntegrator&&) noexcept;

  /// Moves `duration` on with thrusts wanted [N]; appends what happened, in order.
  void Advance(const ThrusterVector& wanted_thrust, double duration,
               std::vector<TimedEvent>& events);
  [[nodiscard]] const StateVector& state() const;
  /// Time since the start [s].
  [[nodiscard]] double time() const;
  /// Steps that CVODE gave up and a fixed step bridged.
  [[nodiscard]] int failures() const;

 private:
  class Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace limpet
