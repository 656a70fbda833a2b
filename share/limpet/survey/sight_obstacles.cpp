// SPDX-License-Identifier: MIT
#include "limpet/survey/sight_obstacles.hpp"

#include <cmath>
#include <utility>

#include "limpet/survey/port_side.hpp"

namespace limpet {

bool Shadows::Hide(const Eigen::Vector3d& place_W) const {
  for (const Shadow& shadow : shadows_) {
    const Eigen::Vector2d to = place_W.head<2>() - eye_W_.head<2>();
    if (CrossToPort(shadow.right, to) < 0.0 || CrossToPort(to, shadow.left) < 0.0) continue;
    const Eigen::Vector2d side = shadow.left - shadow.right;
    // The eye is on the left of the way from the right side to the left one.
    const double from_eye = CrossToPort(side, -shadow.right),
                 beyond = -CrossToPort(side, to - shadow.right);
    if (!(from_eye > 0.0) || beyond < 0.0) continue;
    const double share = from_eye / (from_eye + beyond);  // of the ray, where it meets that line
    if (eye_W_.z() + share * (place_W.z() - eye_W_.z()) >= shadow.top) return true;
  }
  return false;
}

SightObstacles::SightObstacles(const std::vector<Obstacle>& obstacles) {
  for (const Obstacle& obstacle : obstacles) {
    std::vector<PlanePoint> corners;
    for (const auto& [north, east] : obstacle.outline)
      corners.emplace_back(north, east);
    if (auto outline = SimplePolygon::Of(std::move(corners))) {
      bodies_.push_back({.outline = *std::move(outline), .top = obstacle.top});
    }
  }
}

Shadows SightObstacles::From(const Eigen::Vector3d& eye_W, double reach) const {
  Shadows shadows;
  shadows.eye_W_ = eye_W;
  const Eigen::Vector2d eye = eye_W.head<2>();
  for (const Body& body : bodies_) {
    const double depth = body.outline.Depth(eye);
    if (depth >= 0.0 || depth < -reach) continue;
    const Eigen::Vector2d ahead = 0.5 * (body.outline.low() + body.outline.high()) - eye;
    double right = 0.0, left = 0.0;
    Shadows::Shadow shadow{.right = ahead, .left = ahead, .top = body.top};
    for (const PlanePoint& corner : body.outline.corners()) {
      const Eigen::Vector2d to = corner - eye;
      const double angle = std::atan2(CrossToPort(ahead, to), ahead.dot(to));
      if (angle < right) right = angle, shadow.right = to;
      if (angle > left) left = angle, shadow.left = to;
    }
    shadows.shadows_.push_back(shadow);
  }
  return shadows;
}

bool SightObstacles::Hide(const Eigen::Vector3d& eye_W, const Eigen::Vector3d& place_W) const {
  if (bodies_.empty()) return false;
  return From(eye_W, (place_W - eye_W).head<2>().norm()).Hide(place_W);
}

}  // namespace limpet
