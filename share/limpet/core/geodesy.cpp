// SPDX-License-Identifier: MIT
#include "limpet/core/geodesy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace limpet {
namespace {

// WGS84
constexpr double kEquatorialRadius = 6378137.0;  ///< [m]
constexpr double kFlattening = 1.0 / 298.257223563;
constexpr double kPolarRadius = kEquatorialRadius * (1.0 - kFlattening);
constexpr double kEccentricity2 = kFlattening * (2.0 - kFlattening);
constexpr double kSecondEccentricity2 = kEccentricity2 / (1.0 - kEccentricity2);
constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

/// Bowring's formula: one step from the reduced latitude, good to 1e-11 rad near the surface.
GeoPoint GeoPointOf(const Eigen::Vector3d& p) {
  const double from_axis = std::hypot(p.x(), p.y());
  const double reduced = std::atan2(p.z() * kEquatorialRadius, from_axis * kPolarRadius);
  const double sine = std::sin(reduced), cosine = std::cos(reduced);
  const double latitude =
      std::atan2(p.z() + kSecondEccentricity2 * kPolarRadius * sine * sine * sine,
                 from_axis - kEccentricity2 * kEquatorialRadius * cosine * cosine * cosine);
  return {.latitude_deg = latitude / kRadiansPerDegree,
          .longitude_deg = std::atan2(p.y(), p.x()) / kRadiansPerDegree};
}

/// The vertical of a place, upwards, and where it stands on the ellipsoid.
struct Vertical {
  Eigen::Vector3d foot, up;
};
Vertical VerticalAt(const GeoPoint& place) {
  const double latitude = place.latitude_deg * kRadiansPerDegree;
  const double longitude = place.longitude_deg * kRadiansPerDegree;
  const Eigen::Vector3d up(std::cos(latitude) * std::cos(longitude),
                           std::cos(latitude) * std::sin(longitude), std::sin(latitude));
  const double radius = kEquatorialRadius / std::sqrt(1.0 - kEccentricity2 * up.z() * up.z());
  return {.foot = radius * Eigen::Vector3d(up.x(), up.y(), (1.0 - kEccentricity2) * up.z()),
          .up = up};
}

}  // namespace

double DistanceBetween(const GeoPoint& a, const GeoPoint& b) {
  constexpr double kMeanRadius = 6.371e6;  // [m]
  const double north_a = a.latitude_deg * kRadiansPerDegree;
  const double north_b = b.latitude_deg * kRadiansPerDegree;
  // Haversines: exact also for places side by side.
  const double by_north = std::sin(0.5 * (north_b - north_a));
  const double by_east = std::sin(0.5 * kRadiansPerDegree * (b.longitude_deg - a.longitude_deg));
  const double square =
      by_north * by_north + std::cos(north_a) * std::cos(north_b) * by_east * by_east;
  return 2.0 * kMeanRadius * std::asin(std::sqrt(std::min(1.0, square)));
}

LocalGrid::LocalGrid(const GeoPoint& datum) {
  const double latitude = datum.latitude_deg * kRadiansPerDegree;
  const double longitude = datum.longitude_deg * kRadiansPerDegree;
  const double sin_lat = std::sin(latitude), cos_lat = std::cos(latitude);
  const double sin_lon = std::sin(longitude), cos_lon = std::cos(longitude);
  const double curvature_radius =
      kEquatorialRadius / std::sqrt(1.0 - kEccentricity2 * sin_lat * sin_lat);
  origin_ = {curvature_radius * cos_lat * cos_lon, curvature_radius * cos_lat * sin_lon,
             curvature_radius * (1.0 - kEccentricity2) * sin_lat};
  north_ = {-sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat};
  east_ = {-sin_lon, cos_lon, 0.0};
}

GeoPoint LocalGrid::At(const Eigen::Vector2d& p_W) const {
  return GeoPointOf(origin_ + p_W.x() * north_ + p_W.y() * east_);
}

std::optional<Eigen::Vector2d> LocalGrid::Above(const GeoPoint& place) const {
  const auto [foot, up] = VerticalAt(place);
  const Eigen::Vector3d out = east_.cross(north_);  // of the plane
  const double slope = out.dot(up);
  if (!(slope > 0.0)) {
    return std::nullopt;
  }
  const Eigen::Vector3d above = foot - out.dot(foot - origin_) / slope * up - origin_;
  return Eigen::Vector2d(above.dot(north_), above.dot(east_));
}

}  // namespace limpet
