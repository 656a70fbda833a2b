// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace limpet {

/// Takes a point of the former session's frame to this session's: a turn about `pivot_W`, then a
/// shift. What GPS, the first heading and the pressure sensor leave between two sessions. A point
/// `former_W` is in the former session's W, all else in this one's.
struct FrameOffset {
  Eigen::Vector2d shift_W = Eigen::Vector2d::Zero();  ///< north, east [m]
  double turn = 0.0;                                  ///< [rad]
  Eigen::Vector2d pivot_W = Eigen::Vector2d::Zero();  ///< mean of the former objects
  double down = 0.0;                                  ///< [m]

  [[nodiscard]] Eigen::Vector3d Apply(const Eigen::Vector3d& former_W) const;
  [[nodiscard]] Eigen::Vector3d Undo(const Eigen::Vector3d& now_W) const;
  /// Derivative of Apply(former_W) with respect to (north, east, down, turn).
  [[nodiscard]] Eigen::Matrix<double, 3, 4> Jacobian(const Eigen::Vector3d& former_W) const;
  /// (north, east, down, turn).
  [[nodiscard]] Eigen::Vector4d vector() const { return {shift_W.x(), shift_W.y(), down, turn}; }
  void Move(const Eigen::Vector4d& step);
};

/// The turn that brings the direction of one vector to that of another [rad], -pi to pi.
[[nodiscard]] double TurnBetween(const Eigen::Vector2d& from_W, const Eigen::Vector2d& to_W);

/// `first`, then `second`, as one about the pivot of `first`.
[[nodiscard]] FrameOffset Together(const FrameOffset& first, const FrameOffset& second);

}  // namespace limpet
