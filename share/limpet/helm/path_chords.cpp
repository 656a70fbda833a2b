// SPDX-License-Identifier: MIT
#include "limpet/helm/path_chords.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {
namespace {

/// Chords for an arc: the sagitta of a chord of angle a on radius r is r (1 - cos(a/2)).
int ChordsOf(const PathSegment& segment, double sagitta) {
  const double curvature = std::abs(segment.curvature);
  if (curvature < 1e-6) {
    return 1;
  }
  const double angle = 2.0 * std::acos(std::max(0.0, 1.0 - sagitta * curvature));
  return std::max(1, static_cast<int>(std::ceil(curvature * segment.length / angle)));
}

}  // namespace

std::vector<MapPoint> MapPointsOf(const DubinsPath& path, double sagitta) {
  Pose2 pose = path.start();
  std::vector<MapPoint> points{MapPointOf({pose.north, pose.east})};
  for (const PathSegment& segment : path.segments()) {
    const int chords = ChordsOf(segment, sagitta);
    for (int i = 0; i < chords; ++i) {
      pose = Advance(pose, {.curvature = segment.curvature, .length = segment.length / chords});
      points.push_back(MapPointOf({pose.north, pose.east}));
    }
  }
  return points;
}

}  // namespace limpet
