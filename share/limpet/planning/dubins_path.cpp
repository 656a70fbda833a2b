// SPDX-License-Identifier: MIT
#include "limpet/planning/dubins_path.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;
/// An arc this close to a full turn is a rounded 0 (square roots of differences lose half the
/// digits): nobody means a loop of 2 pi - 1e-7.
constexpr double kRoundedZero = 1e-7;
/// Circles with centres this close are one: the direction between them is noise.
constexpr double kSameCircle = 1e-7;
constexpr double kSameCurvature = 1e-12;

/// Angle of an arc in [0, 2 pi), where -1e-16 is 0 and not a full turn.
double ArcAngle(double angle) {
  double wrapped = std::fmod(angle, kFullTurn);
  wrapped = wrapped < 0.0 ? wrapped + kFullTurn : wrapped;
  return wrapped > kFullTurn - kRoundedZero ? 0.0 : wrapped;
}

/// A word in units of the radius: angles of the first and last arc, and the middle's length.
struct Word {
  std::array<int, 3> turns{};  ///< +1 starboard, 0 straight, -1 port
  std::array<double, 3> lengths{};
  [[nodiscard]] double length() const { return lengths[0] + lengths[1] + lengths[2]; }
};

/// Start and end in units of the radius, in axes where the end lies straight ahead (Shkel and
/// Lumelsky's normalisation), angles growing to starboard.
struct Problem {
  double d, alpha, beta;
};

std::optional<Word> Csc(const Problem& p, int first, int last) {
  const double sa = std::sin(p.alpha), ca = std::cos(p.alpha);
  const double sb = std::sin(p.beta), cb = std::cos(p.beta);
  // Vector between the circles' centres: centre = position + turn * (-sin, cos).
  const double cx = p.d - last * sb + first * sa;
  const double cy = last * cb - first * ca;
  const double squared = cx * cx + cy * cy;
  const double direction = std::atan2(cy, cx);
  double straight = 0.0, course = direction;
  if (first == last) {
    straight = std::sqrt(squared);
    course = straight < kSameCircle ? p.alpha : direction;
  } else {
    const double left_over = squared - 4.0;
    if (left_over < 0.0) {
      return std::nullopt;
    }
    straight = std::sqrt(left_over);
    course = direction + first * std::atan2(2.0, straight);
  }
  return Word{{first, 0, last},
              {ArcAngle(first * (course - p.alpha)), straight, ArcAngle(last * (p.beta - course))}};
}

std::optional<Word> Ccc(const Problem& p, int turn) {
  const double cx = p.d - turn * std::sin(p.beta) + turn * std::sin(p.alpha);
  const double cy = turn * std::cos(p.beta) - turn * std::cos(p.alpha);
  const double distance = std::hypot(cx, cy);
  if (distance > 4.0) {
    return std::nullopt;
  }
  const double direction = std::atan2(cy, cx);
  const double half = std::acos(std::min(1.0, distance / 4.0));
  // Of the two middle circles the one that makes the middle arc longer than half a turn is optimal.
  // A point at angle phi of a circle is passed with heading phi plus a quarter turn.
  const double quarter = turn * 0.5 * std::numbers::pi;
  const double leave = direction + turn * half + quarter;
  const double enter = direction + std::numbers::pi - turn * half + quarter;
  return Word{{turn, -turn, turn},
              {ArcAngle(turn * (leave - p.alpha)), ArcAngle(-turn * (enter - leave)),
               ArcAngle(turn * (p.beta - enter))}};
}

std::array<std::optional<Word>, 6> Words(const Problem& p) {
  return {Csc(p, -1, -1), Csc(p, 1, 1), Csc(p, -1, 1), Csc(p, 1, -1), Ccc(p, -1), Ccc(p, 1)};
}

Problem Normalise(const Pose2& from, const Pose2& to, double radius) {
  const double dn = to.north - from.north, de = to.east - from.east;
  const double ahead = std::atan2(de, dn);
  return {.d = std::hypot(dn, de) / radius, .alpha = from.yaw - ahead, .beta = to.yaw - ahead};
}

DubinsPath PathOf(const Pose2& from, const Word& word, double radius) {
  DubinsPath path(from);
  for (std::size_t i = 0; i < 3; ++i) {
    path.Append({.curvature = word.turns[i] / radius, .length = word.lengths[i] * radius});
  }
  return path;
}

}  // namespace

DubinsPath::DubinsPath(const Pose2& start, const std::vector<PathSegment>& segments)
    : start_(start) {
  for (const PathSegment& segment : segments) {
    Append(segment);
  }
}

void DubinsPath::Append(PathSegment segment) {
  LIMPET_REQUIRE(segment.length >= 0.0, "a segment of negative length");
  if (segment.length == 0.0) {
    return;
  }
  length_ += segment.length;
  if (!segments_.empty() &&
      std::abs(segments_.back().curvature - segment.curvature) < kSameCurvature) {
    segments_.back().length += segment.length;
  } else {
    segments_.push_back(segment);
  }
}

void DubinsPath::Append(const DubinsPath& next) {
  for (const PathSegment& segment : next.segments_) {
    Append(segment);
  }
}

Pose2 DubinsPath::At(double s) const {
  Pose2 pose = start_;
  double left = std::max(0.0, s);
  for (const PathSegment& segment : segments_) {
    const double step = std::min(left, segment.length);
    pose = Advance(pose, segment.curvature, step);
    left -= step;
    if (left <= 0.0) {
      break;
    }
  }
  return pose;
}

DubinsPath DubinsPath::Prefix(double length) const {
  DubinsPath prefix(start_);
  double left = std::max(0.0, length);
  for (const PathSegment& segment : segments_) {
    prefix.Append({.curvature = segment.curvature, .length = std::min(left, segment.length)});
    left = std::max(0.0, left - segment.length);
  }
  return prefix;
}

std::vector<DubinsPath> AllDubins(const Pose2& from, const Pose2& to, Meters radius) {
  LIMPET_REQUIRE(radius.value() > 0.0, "turns need a radius");
  std::vector<DubinsPath> paths;
  for (const std::optional<Word>& word : Words(Normalise(from, to, radius.value()))) {
    if (word) {
      paths.push_back(PathOf(from, *word, radius.value()));
    }
  }
  return paths;
}

DubinsPath ShortestDubins(const Pose2& from, const Pose2& to, Meters radius) {
  LIMPET_REQUIRE(radius.value() > 0.0, "turns need a radius");
  std::optional<Word> best;
  for (const std::optional<Word>& word : Words(Normalise(from, to, radius.value()))) {
    if (word && (!best || word->length() < best->length())) {
      best = word;
    }
  }
  return PathOf(from, *best, radius.value());
}

HelmPath ToHelmPath(const DubinsPath& path, int id, const std::string& purpose) {
  return {.id = id,
          .north = path.start().north,
          .east = path.start().east,
          .yaw = path.start().yaw,
          .segments = path.segments(),
          .purpose = purpose};
}

}  // namespace limpet
