// SPDX-License-Identifier: MIT
#include "estimation/matching/frame_offset.hpp"

#include <cmath>

#include <Eigen/Geometry>

#include "limpet/core/cross_product.hpp"
#include "limpet/core/frames.hpp"

namespace limpet {

Eigen::Vector3d FrameOffset::Apply(const Eigen::Vector3d& former_W) const {
  const Eigen::Vector2d moved =
      pivot_W + Eigen::Rotation2Dd(turn) * (former_W.head<2>() - pivot_W) + shift_W;
  return {moved.x(), moved.y(), former_W.z() + down};
}

Eigen::Vector3d FrameOffset::Undo(const Eigen::Vector3d& now_W) const {
  const Eigen::Vector2d moved =
      pivot_W + Eigen::Rotation2Dd(-turn) * (now_W.head<2>() - pivot_W - shift_W);
  return {moved.x(), moved.y(), now_W.z() - down};
}

Eigen::Matrix<double, 3, 4> FrameOffset::Jacobian(const Eigen::Vector3d& former_W) const {
  const Eigen::Vector2d arm = Eigen::Rotation2Dd(turn) * (former_W.head<2>() - pivot_W);
  Eigen::Matrix<double, 3, 4> J;
  J << 1.0, 0.0, 0.0, -arm.y(),  //
      0.0, 1.0, 0.0, arm.x(),    //
      0.0, 0.0, 1.0, 0.0;
  return J;
}

void FrameOffset::Move(const Eigen::Vector4d& step) {
  shift_W += step.head<2>();
  down += step(2);
  turn += step(3);
}

double TurnBetween(const Eigen::Vector2d& from_W, const Eigen::Vector2d& to_W) {
  return std::atan2(CrossOf(from_W, to_W), from_W.dot(to_W));
}

FrameOffset Together(const FrameOffset& first, const FrameOffset& second) {
  FrameOffset both = first;
  both.turn = WrapAngle(first.turn + second.turn);
  both.down += second.down;
  const Eigen::Vector3d pivot_W(first.pivot_W.x(), first.pivot_W.y(), 0.0);
  both.shift_W = second.Apply(first.Apply(pivot_W)).head<2>() - first.pivot_W;
  return both;
}

}  // namespace limpet
