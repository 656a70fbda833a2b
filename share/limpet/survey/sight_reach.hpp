// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace limpet {

/// Plans leave this share of the reach: altitude is not held to the centimetre.
inline constexpr double kPlannedReach = 0.97;

/// How large an image of the ground is [m].
struct GroundImage {
  double distance = 0.0;  ///< below the camera
  double corner = 0.0;    ///< from its centre to its corner, on the ground
};

/// Share of an image's sides that is left of it where one sees `reach` metres far. 0 if that is
/// less than half: lanes twice as dense are the most that is worth it.
[[nodiscard]] inline double ShareInSight(const GroundImage& image, double reach) {
  constexpr double kLeast = 0.5;
  const auto& [distance, corner] = image;
  const double planned = kPlannedReach * reach;
  if (!(distance < planned)) {
    return 0.0;
  }
  const double radius = std::sqrt(planned * planned - distance * distance);
  if (radius >= corner) {
    return 1.0;
  }
  return radius >= kLeast * corner ? radius / corner : 0.0;
}

}  // namespace limpet
