// SPDX-License-Identifier: MIT
#include "limpet/core/geodesy.hpp"

#include <cmath>
#include <numbers>

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

}  // namespace

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

GeoPoint LocalGrid::At(double north, double east) const {
  return GeoPointOf(origin_ + north * north_ + east * east_);
}

}  // namespace limpet
