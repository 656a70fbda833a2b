// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>

#include <Eigen/Core>

#include "estimation/navigation/motion_readings.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// A column for each thruster, in the order of the vehicle's file.
using FullThrust = Eigen::Matrix<double, 2, static_cast<int>(ThrusterShares::kMost)>;

/// How the hull answers to thrust ahead and abeam (surge, sway), as its data sheet says.
struct DriveParams {
  Eigen::Vector2d mass_B{45.0, 65.0};            ///< with what it drags along [kg]
  Eigen::Vector2d linear_drag_B{3.0, 8.0};       ///< [N per m/s]
  Eigen::Vector2d quadratic_drag_B{30.0, 80.0};  ///< [N per (m/s)^2]
  Seconds command_lasts{1.0};                    ///< without another the thrusters stop
  /// What each thruster pushes ahead and abeam when all is asked of it [N]; nothing where that is
  /// not known: no command tells anything then.
  std::optional<FullThrust> full_thrust_B{};
};

/// The speed through the water, ahead and abeam, that commands of the thrusters alone would make,
/// from rest, while the vehicle turns at a known rate r [Fossen 2011]:
///   m_x u' = X + m_y v r - (a_x + b_x |u|) u,   m_y v' = Y - m_x u r - (a_y + b_y |v|) v.
/// Hull and thrusters are never quite what their
/// sheets say, so WaterModel learns how much of it is true. Times in seconds.
class DrivenSpeed {
 public:
  explicit DrivenSpeed(const DriveParams& params) : params_(params) {}

  /// From `t` on the thrusters push with this force, ahead and abeam [N], and the vehicle turns at
  /// this rate [rad/s]. Later than all before.
  void AddForce(double t, const Eigen::Vector2d& force_B, double yaw_rate);
  /// From a command on they push as that asks, each at most as it can.
  void AddCommand(const ThrusterShares& command, double yaw_rate);
  /// [m/s]; nothing before a first command.
  [[nodiscard]] std::optional<Eigen::Vector2d> At(double t) const;
  /// Forgets what is older than `t` and not needed any more.
  void DropBefore(double t);

 private:
  struct Knot {
    double t = 0.0;
    Eigen::Vector2d v_B = Eigen::Vector2d::Zero();
    Eigen::Vector2d force_B = Eigen::Vector2d::Zero();
    double yaw_rate = 0.0;
  };
  /// Velocity at `t`, from a knot on.
  [[nodiscard]] Eigen::Vector2d After(const Knot& knot, double t) const;
  /// So long after the knot, whose force and turn go on.
  [[nodiscard]] Eigen::Vector2d Pushed(const Knot& knot, double seconds) const;

  DriveParams params_;
  std::deque<Knot> knots_;
};

}  // namespace limpet
