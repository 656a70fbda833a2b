// SPDX-License-Identifier: MIT
#include "limpet/simulation/upright_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace limpet {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

}  // namespace

double UprightBody::Aside(const Eigen::Vector2d& at_W) const {
  const Eigen::Vector2d off = at_W - center_W_;
  if (is_column_) return std::max(0.0, off.norm() - half_size_.x());
  return (off.cwiseAbs() - half_size_).cwiseMax(0.0).norm();
}

double UprightBody::Distance(const Eigen::Vector3d& at_W) const {
  return std::hypot(Aside(at_W.head<2>()), std::max(0.0, top_ - at_W.z()));
}

std::optional<UprightBody::Piece> UprightBody::Over(const Eigen::Vector2d& from_center_W,
                                                    const Eigen::Vector2d& direction_W) const {
  Piece piece{-kEndless, kEndless};
  if (is_column_) {
    const double along = direction_W.squaredNorm(), towards = from_center_W.dot(direction_W);
    const double off = from_center_W.squaredNorm() - half_size_.x() * half_size_.x();
    if (along <= 0.0) return off <= 0.0 ? std::optional(piece) : std::nullopt;
    const double half_chord_sq = towards * towards - along * off;
    if (half_chord_sq < 0.0) return std::nullopt;
    const double half_chord = std::sqrt(half_chord_sq) / along;
    return Piece{-towards / along - half_chord, -towards / along + half_chord};
  }
  for (const Eigen::Index axis : {0, 1}) {
    if (direction_W[axis] == 0.0) {
      if (std::abs(from_center_W[axis]) > half_size_[axis]) return std::nullopt;
      continue;
    }
    double near = (-half_size_[axis] - from_center_W[axis]) / direction_W[axis];
    double far = (half_size_[axis] - from_center_W[axis]) / direction_W[axis];
    if (near > far) std::swap(near, far);
    piece = {std::max(piece.first, near), std::min(piece.last, far)};
  }
  return piece.first <= piece.last ? std::optional(piece) : std::nullopt;
}

std::optional<double> UprightBody::Range(const Eigen::Vector3d& origin_W,
                                         const Eigen::Vector3d& direction_W) const {
  const std::optional<Piece> over = Over(origin_W.head<2>() - center_W_, direction_W.head<2>());
  if (!over) return std::nullopt;
  double first = std::max(0.0, over->first), last = over->last;
  const double to_top = top_ - origin_W.z(), descent = direction_W.z();
  if (descent > 0.0) first = std::max(first, to_top / descent);
  if (descent < 0.0) last = std::min(last, to_top / descent);
  if (descent == 0.0 && to_top > 0.0) return std::nullopt;
  return first <= last ? std::optional(first) : std::nullopt;
}

bool UprightBody::IsBetween(const Eigen::Vector3d& from_W, const Eigen::Vector3d& to_W) const {
  const Eigen::Vector3d way = to_W - from_W;
  const double distance = way.norm();
  if (distance <= 0.0) return false;
  const std::optional<double> range = Range(from_W, way / distance);
  return range && *range < distance;
}

}  // namespace limpet
