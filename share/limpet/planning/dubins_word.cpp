// SPDX-License-Identifier: MIT
#include "limpet/planning/dubins_word.hpp"

#include <algorithm>
#include <cmath>
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

}  // namespace

DubinsWords::DubinsWords(const Pose2& from, const Pose2& to, Meters radius) {
  LIMPET_REQUIRE(radius.value() > 0.0, "turns need a radius");
  const double r = radius.value();
  for (const std::optional<Word>& word : Words(Normalise(from, to, r))) {
    if (!word) continue;
    DubinsWord& added = words_[count_++];
    added.length = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      added.segments[i] = {.curvature = word->turns[i] / r, .length = word->lengths[i] * r};
      added.length += added.segments[i].length;
    }
  }
}

const DubinsWord& DubinsWords::shortest() const {
  return *std::ranges::min_element(all(), {}, &DubinsWord::length);
}

}  // namespace limpet
