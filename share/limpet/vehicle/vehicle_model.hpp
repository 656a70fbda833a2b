// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <Eigen/Core>

#include "limpet/core/frames.hpp"
#include "limpet/vehicle/hydrodynamics.hpp"
#include "limpet/vehicle/vehicle_params.hpp"

namespace limpet {

/// NED depth of the seabed at (north, east) [m].
using SeabedFunction = std::function<double(const Eigen::Vector2d& p_W)>;

/// Layout of the state: NED position, quaternion R_WB (scalar first), velocity through the water
/// and angular rate in body axes, thrust of each thruster [N], zero of those that the vehicle has
/// not.
inline constexpr int kStateSize = 13 + kMostThrusters;
using StateVector = Eigen::Matrix<double, kStateSize, 1>;
namespace state_index {
inline constexpr int kPosition = 0;
inline constexpr int kQuaternion = 3;
inline constexpr int kVelocity = 7;
inline constexpr int kRate = 10;
inline constexpr int kThrust = 13;
}  // namespace state_index

/// What sensors and scorers can ask of a state.
struct VehicleMotion {
  Pose X_WB;
  Eigen::Vector3d v_WB_B = Eigen::Vector3d::Zero();  ///< over ground [m/s]
  Eigen::Vector3d omega_B = Eigen::Vector3d::Zero();
  Eigen::Vector3d specific_force_B = Eigen::Vector3d::Zero();  ///< [m/s^2]
};

/// Equations of motion (Fossen 2011 eq. 8.2 with eq. 8.6): rigid body and added mass move with the
/// velocity through the water, which is exact for a current that is constant in W, and near enough
/// for one that changes over minutes:
///   M nu_r' + C(nu_r) nu_r + D(nu_r) nu_r + g(eta) = B thrust + contact.
/// Any number of integrators may share it; only SetCurrent changes it, between their steps.
class VehicleModel {
 public:
  VehicleModel(const VehicleParams& params, const Eigen::Vector3d& current_W,
               SeabedFunction seabed);

  /// North, east, down [m/s]. The velocity through the water stays: that over ground steps.
  void SetCurrent(const Eigen::Vector3d& current_W) { current_W_ = current_W; }
  [[nodiscard]] const Eigen::Vector3d& current_W() const { return current_W_; }

  /// Time derivative. `with_seabed` false leaves out contact, for when IsNearSeabed says so.
  [[nodiscard]] StateVector Derivative(const StateVector& x, const ThrusterVector& wanted_thrust,
                                       bool with_seabed) const;

  /// State at rest, level, afloat at `place_W` (north, east); drifting with the current.
  [[nodiscard]] StateVector Afloat(const Eigen::Vector2d& place_W, double yaw) const;
  [[nodiscard]] VehicleMotion Motion(const StateVector& x,
                                     const ThrusterVector& wanted_thrust) const;

  /// Height of the skids above the seabed below the origin [m].
  [[nodiscard]] double Clearance(const StateVector& x) const;
  /// Whether contact could begin within `duration` [s].
  [[nodiscard]] bool IsNearSeabed(const StateVector& x, double duration) const;

  [[nodiscard]] const VehicleParams& params() const { return params_; }
  [[nodiscard]] const Hydrodynamics& hydrodynamics() const { return hydro_; }

 private:
  VehicleParams params_;
  Hydrodynamics hydro_;
  Matrix6 inverse_mass_;
  ThrusterWrenches wrench_per_thrust_;
  Eigen::Vector3d current_W_;
  SeabedFunction seabed_;
};

}  // namespace limpet
