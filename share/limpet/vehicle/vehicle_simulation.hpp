// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/vehicle/cvode_integrator.hpp"
#include "limpet/vehicle/rk4_integrator.hpp"

namespace limpet {

enum class IntegratorKind { kCvode, kRk4 };

/// A vehicle in its water, moved on by either integrator.
class VehicleSimulation {
 public:
  struct Place {
    double north = 0.0, east = 0.0, yaw = 0.0;
    std::optional<double> down = std::nullopt;  ///< where it floats, if not given
  };
  /// Starts at rest at `start`.
  VehicleSimulation(VehicleModel model, const Place& start, IntegratorKind kind);

  /// Moves `duration` on with normalised thrusts, each in [-1, 1]; beyond that they are clipped as
  /// the thrusters' drives would. Says what happened, in order.
  std::vector<TimedEvent> Advance(const ThrusterVector& command, Seconds duration);

  /// Sets the current from now on [m/s], in W. Small steps only: an integrator takes them for the
  /// same motion.
  void SetCurrent(const Eigen::Vector3d& current_W) { model_->SetCurrent(current_W); }

  [[nodiscard]] VehicleMotion motion() const;
  [[nodiscard]] const StateVector& state() const;
  [[nodiscard]] Seconds time() const;
  [[nodiscard]] int failures() const;
  [[nodiscard]] const VehicleModel& model() const { return *model_; }

 private:
  using Integrator = std::variant<CvodeIntegrator, Rk4Integrator>;
  static Integrator MakeIntegrator(const VehicleModel& model, const Place& start,
                                   IntegratorKind kind);

  std::unique_ptr<VehicleModel> model_;  // integrators point to it
  Integrator integrator_;
  ThrusterVector wanted_thrust_ = ThrusterVector::Zero();
};

}  // namespace limpet
