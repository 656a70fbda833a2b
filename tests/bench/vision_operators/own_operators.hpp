// SPDX-License-Identifier: MIT
// Operators written by hand, to be timed beside OpenCV's. What the product uses of both: docs/adr.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "limpet/vision/ellipse.hpp"
#include "limpet/vision/image.hpp"

namespace limpet::own {

/// Numbers of an image, row by row.
struct Plane {
  int width = 0, height = 0;
  std::vector<std::int16_t> values;
};

/// Means over 4 x 4 pixels.
void Reduce(const Image& image, Image& reduced);

/// Yellowness, redness, greenness as differences over the sum, and distance from the usual colours.
void FillPlanes(const Image& image, double noise, std::array<Plane, 4>& planes);

/// Values below which 16 % and 50 % of every third pixel lie, and the greatest of all.
std::array<int, 3> QuantilesAndMost(const Plane& plane);

/// Moments of the connected regions (8 neighbours) of `plane >= level`, from runs of pixels.
struct Region {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
};
void FindRegions(const Plane& plane, int level, double least_area, std::vector<Region>& regions);

/// Colours along kRays rays of kSteps pixels each, from 0.55 to 1.55 radii, projected.
void SampleRays(const ImageView& image, const Ellipse& ellipse, const Eigen::Vector3d& weights,
                std::vector<double>& profiles);
inline constexpr int kRays = 48;
inline constexpr int kSteps = 48;

}  // namespace limpet::own
