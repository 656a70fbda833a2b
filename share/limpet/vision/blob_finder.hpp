// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace limpet {

/// One connected region of a level set, by its moments. Pixel units of the plane it was found in.
struct Blob {
  double area = 0.0;
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  int left = 0, top = 0, right = 0, bottom = 0;  ///< right and bottom exclusive

  /// Area over that of the ellipse with the same second moments: 1 for any full ellipse, less for
  /// rings, branches and crescents.
  [[nodiscard]] double Fullness() const;
  /// Long over short axis.
  [[nodiscard]] double Elongation() const;
};

/// A plane of numbers in which objects are brighter than what surrounds them.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<std::int16_t> values;

  [[nodiscard]] const std::int16_t* row(int index) const {
    return values.data() + static_cast<std::ptrdiff_t>(index) * width;
  }
};

/// Appends the connected regions (8 neighbours) of `plane >= level` with at least `least_area`
/// pixels, in a fixed order.
void FindBlobs(const Plane& plane, int level, double least_area, std::vector<Blob>& blobs);

}  // namespace limpet
