// SPDX-License-Identifier: MIT
#include "estimation/mapping/dvl_beams.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limpet/vehicle/dvl_reach.hpp"

namespace limpet {
namespace {

constexpr double kTilt = 25.0 * std::numbers::pi / 180.0;
constexpr double kShortest = 0.2;  ///< [m]
constexpr double kLongest = 100.0;
constexpr double kSeabedTolerance = 0.4;  ///< around the beams' median depth [m]
constexpr double kTallestObject = DvlReach{}.tallest_object_m;  ///< above the median
constexpr double kDeepestHole = 1.0;                            ///< and this far below

Eigen::Vector3d Direction(std::size_t beam) {
  const double azimuth = (45.0 + 90.0 * static_cast<double>(beam)) * std::numbers::pi / 180.0;
  return {std::sin(kTilt) * std::cos(azimuth), std::sin(kTilt) * std::sin(azimuth),
          std::cos(kTilt)};
}

/// Of two middle values the deeper one: an object pulls beams up, nothing pulls them down.
double MedianDepth(const std::vector<BeamEnd>& ends) {
  std::vector<double> depths;
  for (const BeamEnd& end : ends) {
    depths.push_back(end.p_W.z());
  }
  std::ranges::sort(depths);
  return depths[depths.size() / 2];
}

}  // namespace

std::vector<BeamEnd> BeamEnds(const Pose& X_WD,
                              const std::array<std::optional<double>, 4>& ranges) {
  const Eigen::Matrix3d R_WD = RotationOf(X_WD);
  std::vector<BeamEnd> ends;
  for (std::size_t beam = 0; beam < ranges.size(); ++beam) {
    const double range = ranges[beam].value_or(0.0);
    if (range >= kShortest && range <= kLongest) {
      ends.push_back({.p_W = X_WD.p_WB + R_WD * (range * Direction(beam)), .is_seabed = false});
    }
  }
  if (ends.empty()) {
    return ends;
  }
  const double median = MedianDepth(ends);
  std::erase_if(ends, [median](const BeamEnd& end) {
    return end.p_W.z() < median - kTallestObject || end.p_W.z() > median + kDeepestHole;
  });
  for (BeamEnd& end : ends) {
    end.is_seabed = std::abs(end.p_W.z() - median) <= kSeabedTolerance;
  }
  return ends;
}

}  // namespace limpet
