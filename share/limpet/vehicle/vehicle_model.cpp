// SPDX-License-Identifier: MIT
#include "limpet/vehicle/vehicle_model.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "limpet/vehicle/seabed_contact.hpp"

namespace limpet {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using namespace state_index;

/// Pulls the quaternion's norm to one [1/s]; renormalising inside a solver would need a restart.
constexpr double kNormGain = 1.0;
/// Faster than the vehicle can fall or dive [m/s]; bounds how soon it can reach the seabed.
constexpr double kFastest = 3.0;

Matrix3d RotationOf(const Vector4d& q) {
  return Eigen::Quaterniond(q(0), q(1), q(2), q(3)).toRotationMatrix();
}

/// q' = 1/2 q (0, omega) (Fossen 2011 eq. 2.64), with the norm pulled to one.
Vector4d QuaternionRate(const Vector4d& q, const Vector3d& omega) {
  Vector4d rate;
  rate(0) = -0.5 * q.tail<3>().dot(omega);
  rate.tail<3>() = 0.5 * (q(0) * omega + q.tail<3>().cross(omega));
  return rate + kNormGain * (1.0 - q.squaredNorm()) * q;
}

/// C(nu) nu for any constant mass matrix (Fossen 2011 eq. 3.46); it does no work.
Vector6 Coriolis(const Matrix6& M, const Vector6& nu) {
  const Vector6 momentum = M * nu;
  const Vector3d v = nu.head<3>();
  const Vector3d omega = nu.tail<3>();
  Vector6 force;
  force << omega.cross(momentum.head<3>()),
      v.cross(momentum.head<3>()) + omega.cross(momentum.tail<3>());
  return force;
}

}  // namespace

VehicleModel::VehicleModel(const VehicleParams& params, const Vector3d& current_W,
                           SeabedFunction seabed)
    : params_(params),
      hydro_(DeriveHydrodynamics(params)),
      inverse_mass_(hydro_.mass_matrix.inverse()),
      wrench_per_thrust_(params.thrusters.WrenchPerThrust()),
      current_W_(current_W),
      seabed_(std::move(seabed)) {}

StateVector VehicleModel::Derivative(const StateVector& x, const ThrusterVector& wanted_thrust,
                                     bool with_seabed) const {
  const Matrix3d R_WB = RotationOf(x.segment<4>(kQuaternion));
  const Vector6 nu = x.segment<6>(kVelocity);
  const Vector3d omega = nu.tail<3>();
  const Vector3d v_W = R_WB * nu.head<3>() + current_W_;
  const Vector3d down_B = R_WB.row(2).transpose();

  Vector6 force =
      wrench_per_thrust_ * x.segment<kMostThrusters>(kThrust) - Coriolis(hydro_.mass_matrix, nu);
  force.array() -=
      (hydro_.linear_drag.array() + hydro_.quadratic_drag.array() * nu.array().abs()) * nu.array();
  const double buoyancy = hydro_.buoyancy_n * SubmergedShare({.depth = x(kPosition + 2),
                                                              .half_height = hydro_.half_height_m});
  force.head<3>() += (hydro_.weight_n - buoyancy) * down_B;
  force.tail<3>() += Vector3d(0.0, 0.0, params_.cg_below_cb_m).cross(hydro_.weight_n * down_B);
  if (with_seabed) {
    force +=
        SeabedContactWrench(params_.contact, seabed_, {x.segment<3>(kPosition), R_WB, v_W, omega});
  }

  StateVector rate;
  rate.segment<3>(kPosition) = v_W;
  rate.segment<4>(kQuaternion) = QuaternionRate(x.segment<4>(kQuaternion), omega);
  rate.segment<6>(kVelocity) = inverse_mass_ * force;
  rate.segment<kMostThrusters>(kThrust) =
      (wanted_thrust - x.segment<kMostThrusters>(kThrust)) / params_.thrusters.lag_s;
  return rate;
}

StateVector VehicleModel::Afloat(const Eigen::Vector2d& place_W, double yaw) const {
  StateVector x = StateVector::Zero();
  x.segment<3>(kPosition) << place_W, FloatingDepth(hydro_);
  x(kQuaternion) = std::cos(0.5 * yaw);
  x(kQuaternion + 3) = std::sin(0.5 * yaw);
  return x;
}

VehicleMotion VehicleModel::Motion(const StateVector& x,
                                   const ThrusterVector& wanted_thrust) const {
  const Matrix3d R_WB = RotationOf(x.segment<4>(kQuaternion).normalized());
  const StateVector rate = Derivative(x, wanted_thrust, IsNearSeabed(x, 0.0));
  const Vector3d v = x.segment<3>(kVelocity);
  const Vector3d omega = x.segment<3>(kRate);
  const Vector3d rpy = RollPitchYawFromRotation(R_WB);
  return {.X_WB = {x.segment<3>(kPosition), rpy.x(), rpy.y(), rpy.z()},
          .v_WB_B = v + R_WB.transpose() * current_W_,
          .omega_B = omega,
          .specific_force_B = rate.segment<3>(kVelocity) + omega.cross(v) -
                              params_.gravity * R_WB.row(2).transpose()};
}

double VehicleModel::Clearance(const StateVector& x) const {
  return seabed_({x(kPosition), x(kPosition + 1)}) - x(kPosition + 2) -
         params_.contact.skids_B.front().z();
}

bool VehicleModel::IsNearSeabed(const StateVector& x, double duration) const {
  constexpr double kAlways = 0.6;  // skids of a pitching hull on a slope, and the event's threshold
  return Clearance(x) < kAlways + kFastest * duration;
}

}  // namespace limpet
