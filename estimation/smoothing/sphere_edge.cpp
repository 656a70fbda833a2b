// SPDX-License-Identifier: MIT
#include "estimation/smoothing/sphere_edge.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {
namespace {

constexpr double kWidest = 1.4;      // [rad] from the optical axis
constexpr double kNotInside = 1.02;  // radii from the centre
/// As far as the extent of a whole sphere goes: the sine of its half angle, and its ends' angles
/// from the optical axis [rad].
constexpr double kMostSine = 0.99, kFarthest = 1.5;
/// Of the radius: a sphere that the border misses, or barely touches, ends in a circle this small
/// there. Of its true one the derivative is without bound.
constexpr double kLeastCircle = 0.1;

/// One axis of an image: focal length, principal point and size [px].
struct PinholeAxis {
  double f, c;
  int size_px;
};

PinholeAxis AxisOf(const CameraModel& camera, int axis) {
  if (axis == 0) return {camera.fx, camera.cx, camera.width_px};
  return {camera.fy, camera.cy, camera.height_px};
}

/// A sphere's centre: along the axis of the end, along the image's other axis, and ahead [m].
struct SphereCentre {
  double along, across, depth;
};

/// A circle about (along, ahead) [m] in a plane through the camera and the axis of the end, and how
/// it follows from the sphere. The plane holds (along, slope, 1).
struct PlaneCircle {
  double along, ahead, radius;
  double slope = 0.0;             ///< of the plane, across per depth
  double radius_by_height = 0.0;  ///< as the sphere's centre leaves the plane
  double radius_by_log = 0.0;     ///< by the logarithm of the sphere's radius [m]
  [[nodiscard]] double stretch() const { return std::hypot(1.0, slope); }
};

/// A direction in such a plane that touches the circle [rad], with derivatives.
struct TangentAngle {
  double angle, by_along, by_ahead, by_radius;
};

std::optional<TangentAngle> TangentTo(const PlaneCircle& circle, BoxSide side) {
  const double sign = side == BoxSide::kHigh ? 1.0 : -1.0;
  const double distance = std::hypot(circle.along, circle.ahead);
  if (distance <= kNotInside * circle.radius) return std::nullopt;
  const double squared = distance * distance;
  const double tangent = std::sqrt(squared - circle.radius * circle.radius);
  const double angle =
      std::atan2(circle.along, circle.ahead) + sign * std::asin(circle.radius / distance);
  if (std::abs(angle) >= kWidest) return std::nullopt;
  const double half_per_metre = -sign * circle.radius / (squared * tangent);
  return TangentAngle{.angle = angle,
                      .by_along = circle.ahead / squared + half_per_metre * circle.along,
                      .by_ahead = -circle.along / squared + half_per_metre * circle.ahead,
                      .by_radius = sign / tangent};
}

/// Of the sphere as if the image had no border: its outline's extreme is in the plane of its
/// centre.
PlaneCircle WholeCircle(const SphereCentre& centre, double radius) {
  return {.along = centre.along, .ahead = centre.depth, .radius = radius, .radius_by_log = radius};
}

/// Where the plane of that slope, of the image's border, cuts the sphere.
PlaneCircle CircleAtBorder(const SphereCentre& centre, double radius, double slope) {
  const double stretch = std::hypot(1.0, slope);
  const double height = (centre.across - slope * centre.depth) / stretch;
  PlaneCircle circle{.along = centre.along,
                     .ahead = (slope * centre.across + centre.depth) / stretch,
                     .radius = kLeastCircle * radius,
                     .slope = slope,
                     .radius_by_log = kLeastCircle * radius};
  const double squared = radius * radius - height * height;
  if (squared > circle.radius * circle.radius) {
    circle.radius = std::sqrt(squared);
    circle.radius_by_height = -height / circle.radius;
    circle.radius_by_log = radius * radius / circle.radius;
  }
  return circle;
}

SphereEdge Projected(const PlaneCircle& circle, const TangentAngle& tangent,
                     const PinholeAxis& image, int axis) {
  const double stretch = circle.stretch(), cosine = std::cos(tangent.angle);
  const double by_angle = image.f * stretch / (cosine * cosine);
  // How the circle moves with the centre: its height above the plane is across it.
  const double by_height = tangent.by_radius * circle.radius_by_height;
  SphereEdge edge{.px = image.c + image.f * stretch * std::tan(tangent.angle)};
  edge.by_p_C(axis) = by_angle * tangent.by_along;
  edge.by_p_C(1 - axis) = by_angle * (tangent.by_ahead * circle.slope + by_height) / stretch;
  edge.by_p_C(2) = by_angle * (tangent.by_ahead - by_height * circle.slope) / stretch;
  edge.by_log_radius = by_angle * tangent.by_radius * circle.radius_by_log;
  return edge;
}

/// Where the tangent touches the sphere, along the image's other axis [px].
double TouchedAt(const SphereCentre& centre, const PlaneCircle& circle, double angle,
                 const PinholeAxis& other) {
  const double reach = std::sqrt(centre.along * centre.along + centre.depth * centre.depth -
                                 circle.radius * circle.radius);
  return other.c + other.f * centre.across / (reach * std::cos(angle));
}

}  // namespace

SphereExtent ExtentOfSphere(const CameraModel& camera, const Eigen::Vector3d& p_C, double radius,
                            int axis) {
  const PinholeAxis image = AxisOf(camera, axis);
  const double side = p_C(axis), depth = p_C.z();
  const double middle = std::atan2(side, depth);
  const double half = std::asin(std::min(radius / std::hypot(side, depth), kMostSine));
  return {.low = image.c + image.f * std::tan(std::max(middle - half, -kFarthest)),
          .centre = image.c + image.f * side / depth,
          .high = image.c + image.f * std::tan(std::min(middle + half, kFarthest))};
}

std::optional<SphereEdge> EdgeOfSphere(const CameraModel& camera, const Eigen::Vector3d& p_C,
                                       double radius, BoxEnd end) {
  const PinholeAxis image = AxisOf(camera, end.axis), other = AxisOf(camera, 1 - end.axis);
  const SphereCentre centre{.along = p_C(end.axis), .across = p_C(1 - end.axis), .depth = p_C.z()};
  PlaneCircle circle = WholeCircle(centre, radius);
  std::optional<TangentAngle> tangent = TangentTo(circle, end.side);
  if (!tangent) return std::nullopt;
  const double touched = TouchedAt(centre, circle, tangent->angle, other);
  const double border = std::clamp(touched, 0.0, static_cast<double>(other.size_px));
  if (border != touched) {
    circle = CircleAtBorder(centre, radius, (border - other.c) / other.f);
    tangent = TangentTo(circle, end.side);
    if (!tangent) return std::nullopt;
  }
  return Projected(circle, *tangent, image, end.axis);
}

}  // namespace limpet
