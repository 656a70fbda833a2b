// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>

namespace limpet {

/// A place on the WGS84 ellipsoid [deg].
struct GeoPoint {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
};

/// Along the great circle of a sphere as large as the earth [m]: within 0.6 %, at any distance.
[[nodiscard]] double DistanceBetween(const GeoPoint& a, const GeoPoint& b);

/// The local grid: the plane that touches the ellipsoid at the datum, axes true north and east
/// there. (MOOS's viewers lay a UTM grid instead: turned by its convergence, up to 3 deg, and up to
/// 0.04 % shorter.)
class LocalGrid {
 public:
  explicit LocalGrid(const GeoPoint& datum);

  /// The place below a point of the plane.
  [[nodiscard]] GeoPoint At(const Eigen::Vector2d& p_W) const;
  /// The inverse: the point of the plane (north, east) [m] straight above a place; nothing where
  /// the plane is not above it, on the other side of the earth.
  [[nodiscard]] std::optional<Eigen::Vector2d> Above(const GeoPoint& place) const;

 private:
  Eigen::Vector3d origin_, north_, east_;  ///< earth-centred, earth-fixed
};

}  // namespace limpet
