// SPDX-License-Identifier: MIT
#include "limpet/planning/current_toll.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {

double CurrentToll(const CourseCost& cost, const Pose2& from, const PathSegment& piece) {
  if (cost.metres.empty()) return 0.0;
  return piece.length * (cost.At(from.yaw + 0.5 * piece.curvature * piece.length) - 1.0);
}

double CurrentToll(const CourseCost& cost, const DubinsPath& path) {
  constexpr double kTurn = 0.2;  // [rad] of an arc that counts as one course
  if (cost.metres.empty()) return 0.0;
  double toll = 0.0;
  Pose2 at = path.start();
  for (const PathSegment& segment : path.segments()) {
    const double turned = std::abs(segment.curvature) * segment.length;
    const int pieces = std::max(1, static_cast<int>(std::ceil(turned / kTurn)));
    const PathSegment piece{.curvature = segment.curvature, .length = segment.length / pieces};
    for (int i = 0; i < pieces; ++i) {
      toll += CurrentToll(cost, at, piece);
      at = Advance(at, piece);
    }
  }
  return toll;
}

}  // namespace limpet
