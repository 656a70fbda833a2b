// SPDX-License-Identifier: MIT
#include "estimation/mapping/dvl_beams.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "limpet/core/statistics.hpp"

namespace limpet {
namespace {

constexpr double kShortest = 0.2;  ///< [m]
constexpr double kLongest = 100.0;
constexpr double kSeabedTolerance = 0.4;  ///< around the beams' median depth [m]
constexpr double kDeepestHole = 1.0;      ///< a beam may end this far below the median
/// On a slope that grows with the beams' spread: up to 37 degrees, as a share of the height.
constexpr double kSteepestSeabed = 0.35;

Eigen::Vector3d Direction(std::size_t beam, const DvlBeams& dvl) {
  const double azimuth =
      (45.0 + 90.0 * static_cast<double>(beam)) * std::numbers::pi / 180.0 + dvl.yaw.value();
  const double tilt = dvl.from_vertical.value();
  return {std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth), std::cos(tilt)};
}

/// Median of the ends' depths [m]; of two middle values the deeper one: an object pulls beams up,
/// nothing pulls them down.
double MedianDepth(const std::vector<BeamEnd>& ends) {
  std::vector<double> depths;
  for (const BeamEnd& end : ends) {
    depths.push_back(end.p_W.z());
  }
  return UpperMedian(std::move(depths));
}

}  // namespace

std::array<Eigen::Vector3d, 4> BeamDirections(const DvlBeams& dvl) {
  return {Direction(0, dvl), Direction(1, dvl), Direction(2, dvl), Direction(3, dvl)};
}

std::vector<BeamEnd> BeamEnds(const Pose& X_WD, const std::array<std::optional<double>, 4>& ranges,
                              double tallest_object, const DvlBeams& dvl) {
  const Eigen::Matrix3d R_WD = RotationOf(X_WD);
  std::vector<BeamEnd> ends;
  for (std::size_t beam = 0; beam < ranges.size(); ++beam) {
    const double range = ranges[beam].value_or(0.0);
    if (range >= kShortest && range <= kLongest) {
      ends.push_back({.p_W = X_WD.p_WB + R_WD * (range * Direction(beam, dvl)),
                      .is_seabed = false,
                      .beam = beam});
    }
  }
  if (ends.empty()) {
    return ends;
  }
  const double median = MedianDepth(ends);
  const double slope = kSteepestSeabed * (median - X_WD.p_WB.z());
  const double highest = median - std::max(tallest_object, slope);
  const double deepest = median + std::max(kDeepestHole, slope);
  std::erase_if(ends, [highest, deepest](const BeamEnd& end) {
    return end.p_W.z() < highest || end.p_W.z() > deepest;
  });
  for (BeamEnd& end : ends) {
    end.is_seabed = std::abs(end.p_W.z() - median) <= kSeabedTolerance;
  }
  return ends;
}

}  // namespace limpet
