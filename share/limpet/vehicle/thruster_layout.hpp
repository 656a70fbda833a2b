// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limpet/core/params.hpp"

namespace limpet {

/// As many thrusters as a vehicle may have; `ThrusterLayout` says how many it has.
inline constexpr int kMostThrusters = 8;
/// Something of each thruster; zero of those that a vehicle has not.
using ThrusterVector = Eigen::Matrix<double, kMostThrusters, 1>;
/// Wrench of 1 N of each thruster, a column each.
using ThrusterWrenches = Eigen::Matrix<double, 6, kMostThrusters>;
/// Force [N] and moment [N m] on the body origin: X, Y, Z, K, M, N.
using Wrench = Eigen::Matrix<double, 6, 1>;

/// A thruster pushes the vehicle along its axis.
struct Thruster {
  Eigen::Vector3d p_B;
  Eigen::Vector3d axis_B;
};

/// Four vectored thrusters in the horizontal plane (fore starboard, fore port, aft starboard, aft
/// port; each pushes forward and, by 45 deg, sideways) and two vertical ones (fore, aft; positive
/// pushes down), unless a vehicle's file says otherwise.
struct ThrusterLayout {
  static constexpr double kDiagonal = 0.70710678118654752;  // cos and sin of 45 deg
  /// The thrusters that the vehicle has, at most kMostThrusters.
  std::vector<Thruster> thrusters = {{{0.2, 0.2, 0.0}, {kDiagonal, -kDiagonal, 0.0}},
                                     {{0.2, -0.2, 0.0}, {kDiagonal, kDiagonal, 0.0}},
                                     {{-0.2, 0.2, 0.0}, {kDiagonal, kDiagonal, 0.0}},
                                     {{-0.2, -0.2, 0.0}, {kDiagonal, -kDiagonal, 0.0}},
                                     {{0.2, 0.0, 0.0}, {0.0, 0.0, 1.0}},
                                     {{-0.2, 0.0, 0.0}, {0.0, 0.0, 1.0}}};
  /// Either way, at normalised command 1 or -1. Four times this at 45 deg is 35 N: 1 m/s.
  double max_thrust_n = 12.5;
  /// First-order lag from command to thrust.
  double lag_s = 0.12;

  /// What all thrusters have in common; where they are is a list of its own in a vehicle's file.
  template <class V>
  void Describe(V& visit) {
    visit("max_thrust_n", max_thrust_n, "Greatest thrust of one thruster, either way [N]",
          InRange(0.1, 1000.0));
    visit("lag_s", lag_s, "First-order lag from command to thrust [s]", InRange(0.01, 2.0));
  }

  /// Axes of a wrench that the thrusters can push along or turn about, each by itself: surge, sway,
  /// heave and yaw, and pitch where some thrusters stand ahead of others. Roll is left to the
  /// righting moment, and so is pitch if it is not among them. Empty if surge, sway, heave or yaw
  /// is not.
  [[nodiscard]] std::vector<int> ControlledAxes() const;
  /// Greatest force up or down if no thruster had to do anything else [N].
  [[nodiscard]] double MostHeave() const;
  [[nodiscard]] ThrusterWrenches WrenchPerThrust() const;
  /// A thruster whose mirror image on the other side is missing: a vehicle that has it still pushes
  /// every way, and every push ahead turns it.
  [[nodiscard]] std::optional<std::size_t> Unpaired() const;
  /// True if all that push up or down together can do so without pitching the vehicle.
  [[nodiscard]] bool HeavesLevel() const;
};

}  // namespace limpet
