// SPDX-License-Identifier: MIT
#include "limpet/planning/sweep_memory.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "limpet/planning/motion_hash.hpp"

namespace limpet {
namespace {

constexpr double kPiece = 4.0;      ///< longest piece of a straight motion [m]
constexpr double kTurnPiece = 2.0;  ///< of one that turns [m]

}  // namespace

void SweepMemory::Reset(const Ground& ground) {
  if (version_ == ground.version()) return;
  version_ = ground.version();
  blank_.Reset(ground);
  for (Known& known : known_) {
    known.is_known = false;
  }
}

const SweptMotion& SweepMemory::Of(const Pose2& from, const PathSegment& segment) {
  Known& known =
      known_[HashOf({from.north, from.east, from.yaw, segment.curvature, segment.length}) %
             kPlaces];
  if (!known.is_known || !IsSame(known.from, from) || !IsSame(known.segment, segment)) {
    known.from = from;
    known.segment = segment;
    known.is_known = true;
    Trace(from, segment, known.motion);
  }
  return known.motion;
}

void SweepMemory::Trace(const Pose2& from, const PathSegment& segment, SweptMotion& motion) {
  motion.pieces.clear();
  const double longest = segment.curvature == 0.0 ? kPiece : kTurnPiece;
  const int pieces = std::max(1, static_cast<int>(std::ceil(segment.length / longest)));
  const PathSegment piece{.curvature = segment.curvature, .length = segment.length / pieces};
  const SeenPlanes::Moment start = blank_.Mark();
  for (int i = 0; i < pieces; ++i) {
    const Pose2 at = Advance(from, {.curvature = segment.curvature, .length = piece.length * i});
    blank_.Sweep(at, piece);
    motion.pieces.push_back({.from = at, .motion = piece, .shown_end = blank_.Mark().noted});
  }
  for (std::size_t plane = 0; plane < SeenPlanes::kPlanes; ++plane) {
    const std::span<const SeenPlanes::Bits> shown = blank_.Since(plane, 0);
    motion.shown[plane].assign(shown.begin(), shown.end());
  }
  blank_.Rewind(start);
}

}  // namespace limpet
