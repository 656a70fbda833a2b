// SPDX-License-Identifier: MIT
#include "limpet/planning/line_of_sight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limpet/core/frames.hpp"
#include "limpet/core/require.hpp"

namespace limpet {
namespace {

/// Flatter than this [1/m] is a line: a sagitta below a micrometre in 10 m.
constexpr double kFlat = 1e-7;
constexpr double kRunOut = 1e6;  // [m]

}  // namespace

void LineOfSight::SetPath(const Pose2& start, const std::vector<PathSegment>& segments) {
  pieces_.clear();
  pieces_.reserve(segments.size() + 1);
  length_ = 0.0;
  progress_ = 0.0;
  Pose2 end = start;
  for (const PathSegment& segment : segments) {
    if (segment.length <= 0.0) continue;
    pieces_.push_back({end, segment.curvature, segment.length, length_});
    end = Advance(end, segment);
    length_ += segment.length;
  }
  pieces_.push_back({end, 0.0, kRunOut, length_});
}

double LineOfSight::Nearest(const Piece& piece, const Eigen::Vector2d& place_W,
                            const Interval& stretch) {
  const double curvature = piece.curvature;
  const double dn = place_W.x() - piece.start.north;
  const double de = place_W.y() - piece.start.east;
  const double c = std::cos(piece.start.yaw);
  const double s = std::sin(piece.start.yaw);
  if (std::abs(curvature) < kFlat) return stretch.Nearest(dn * c + de * s);
  // Seen from the arc's centre the point lies where the path has this yaw.
  const double from_center_n = dn * curvature + s;
  const double from_center_e = de * curvature - c;
  const double yaw = std::atan2(from_center_n, -from_center_e);
  const double turn = WrapAngle(yaw - piece.start.yaw - curvature * stretch.middle());
  return stretch.Nearest(stretch.middle() + turn / curvature);
}

double LineOfSight::NearestAhead(const Eigen::Vector2d& place_W) const {
  const double limit = progress_ + params_.search.value();
  double best = progress_;
  double best_distance = std::numeric_limits<double>::infinity();
  for (const Piece& piece : pieces_) {
    if (piece.begin > limit) break;
    const Interval stretch{std::max(0.0, progress_ - piece.begin),
                           std::min(piece.length, limit - piece.begin)};
    if (stretch.is_empty()) continue;
    const double along = Nearest(piece, place_W, stretch);
    const Pose2 at = Advance(piece.start, {.curvature = piece.curvature, .length = along});
    const double distance = std::hypot(place_W.x() - at.north, place_W.y() - at.east);
    if (distance < best_distance) {
      best = piece.begin + along;
      best_distance = distance;
    }
  }
  return best;
}

Pose2 LineOfSight::At(double progress) const {
  LIMPET_REQUIRE(has_path(), "SetPath comes first");
  const auto after = std::ranges::upper_bound(pieces_, progress, {}, &Piece::begin);
  const Piece& piece = after == pieces_.begin() ? *after : *std::prev(after);
  return Advance(piece.start, {.curvature = piece.curvature, .length = progress - piece.begin});
}

/// The path's own turn, averaged over the time in which the vehicle can answer it (a Dubins path's
/// curvature jumps, a vehicle's turn rate does not), and the turn back to the path.
double LineOfSight::TurnRate(double cross_track, MetersPerSecond speed) const {
  const double window = std::max(0.05, 2.0 * params_.preview.value() * speed.value());
  const double curvature = (At(progress_ + window).yaw - At(progress_).yaw) / window;
  // On the outside of an arc there is more way to go for the same turn.
  const double stretch = std::clamp(1.0 - curvature * cross_track, 0.5, 2.0);
  const double lookahead = params_.lookahead.value();
  const double reach = std::hypot(lookahead, cross_track);
  const double closing = speed.value() * cross_track * lookahead / (reach * reach * reach);
  return curvature * speed.value() / stretch + closing;
}

LineOfSight::Steering LineOfSight::Update(const Eigen::Vector2d& place_W, double speed) {
  LIMPET_REQUIRE(has_path(), "SetPath comes first");
  progress_ = NearestAhead(place_W);
  const Pose2 at = At(progress_);
  const double cross_track =
      -std::sin(at.yaw) * (place_W.x() - at.north) + std::cos(at.yaw) * (place_W.y() - at.east);
  const double limit = params_.max_intercept.value();
  const double intercept =
      std::clamp(std::atan2(-cross_track, params_.lookahead.value()), -limit, limit);
  return {.progress = std::min(progress_, length_),
          .remaining = std::max(0.0, length_ - progress_),
          .cross_track = cross_track,
          .path_course = WrapAngle(at.yaw),
          .course = WrapAngle(at.yaw + intercept),
          .turn_rate = TurnRate(cross_track, MetersPerSecond(speed)),
          .has_arrived = progress_ >= length_};
}

}  // namespace limpet
