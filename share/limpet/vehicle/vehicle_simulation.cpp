// SPDX-License-Identifier: MIT
#include "limpet/vehicle/vehicle_simulation.hpp"

#include <utility>

namespace limpet {

VehicleSimulation::VehicleSimulation(VehicleModel model, const Place& start, IntegratorKind kind)
    : model_(std::make_unique<VehicleModel>(std::move(model))),
      integrator_(MakeIntegrator(*model_, start, kind)) {}

VehicleSimulation::Integrator VehicleSimulation::MakeIntegrator(const VehicleModel& model,
                                                                const Place& start,
                                                                IntegratorKind kind) {
  StateVector x = model.Afloat({start.north, start.east}, start.yaw);
  x(2) = start.down.value_or(x(2));
  if (kind == IntegratorKind::kCvode) return CvodeIntegrator(model, x);
  return Rk4Integrator(model, x);
}

std::vector<TimedEvent> VehicleSimulation::Advance(const ThrusterVector& command,
                                                   Seconds duration) {
  wanted_thrust_ = model_->params().thrusters.max_thrust_n * command.cwiseMax(-1.0).cwiseMin(1.0);
  std::vector<TimedEvent> events;
  std::visit([&](auto& one) { one.Advance(wanted_thrust_, duration.value(), events); },
             integrator_);
  return events;
}

VehicleMotion VehicleSimulation::motion() const { return model_->Motion(state(), wanted_thrust_); }

const StateVector& VehicleSimulation::state() const {
  return std::visit([](const auto& one) -> const StateVector& { return one.state(); }, integrator_);
}

Seconds VehicleSimulation::time() const {
  return Seconds(std::visit([](const auto& one) { return one.time(); }, integrator_));
}

int VehicleSimulation::failures() const {
  return std::visit([](const auto& one) { return one.failures(); }, integrator_);
}

}  // namespace limpet
