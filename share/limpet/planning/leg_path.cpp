// SPDX-License-Identifier: MIT
#include "limpet/planning/leg_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace limpet {
namespace {

constexpr int kEndHeadings = 36;
/// Headings at a corner of the way, off the one between its two legs [rad].
constexpr std::array kOffBisector{0.0, -0.2, 0.2, -0.5, 0.5, -1.0, 1.0};
constexpr double kNotAllowed = 1e4;  ///< what a leg costs that does not keep what it must [m]

/// A way as far as to one pose, and how it got there.
struct Arrival {
  Pose2 pose;
  double cost = std::numeric_limits<double>::infinity();
  DubinsPath last_leg{};
  const Arrival* before = nullptr;
};
/// All ways to the end of one leg.
using Stage = std::vector<Arrival>;

std::vector<Pose2> PosesAt(const std::vector<LegEnd>& legs, std::size_t i, const Pose2& start,
                           const AllowsEnd& allows_end) {
  const PlanePoint& at = legs[i].at_W;
  std::vector<Pose2> poses;
  if (legs[i].heading) return {{at.x(), at.y(), *legs[i].heading}};
  if (i + 1 == legs.size()) {
    for (int k = 0; k < kEndHeadings; ++k) {
      const Pose2 pose{at.x(), at.y(), 2.0 * std::numbers::pi * k / kEndHeadings};
      if (!allows_end || allows_end(pose)) poses.push_back(pose);
    }
    return poses;
  }
  const PlanePoint before = i > 0 ? legs[i - 1].at_W : PlanePoint(start.north, start.east);
  const PlanePoint way = (at - before).normalized() + (legs[i + 1].at_W - at).normalized();
  const double bisector = std::atan2(way.y(), way.x());
  for (const double off : kOffBisector) {
    poses.push_back({at.x(), at.y(), bisector + off});
  }
  return poses;
}

/// Makes `arrival` a way by one of `stage`, if that is the cheaper one.
void GoOn(const Stage& stage, const LegEnd& leg, Meters radius, Arrival& arrival) {
  for (const Arrival& before : stage) {
    for (DubinsPath& path : AllDubins(before.pose, arrival.pose, radius)) {
      const double least = before.cost + path.length();
      if (least >= arrival.cost) continue;
      const double cost = least + (leg.allows(path) ? 0.0 : kNotAllowed);
      if (cost < arrival.cost) {
        arrival.cost = cost;
        arrival.before = &before;
        arrival.last_leg = std::move(path);
      }
    }
  }
}

DubinsPath WayTo(const Arrival& end) {
  std::vector<const Arrival*> way;
  for (const Arrival* at = &end; at != nullptr; at = at->before) {
    way.push_back(at);
  }
  DubinsPath path(way.back()->pose);
  for (auto at = way.rbegin() + 1; at != way.rend(); ++at) {
    path.Append((*at)->last_leg);
  }
  return path;
}

}  // namespace

std::optional<DubinsPath> PathAlong(const Pose2& start, const std::vector<LegEnd>& legs,
                                    Meters radius, const AllowsEnd& allows_end) {
  std::vector<Stage> stages{{{.pose = start, .cost = 0.0}}};
  for (std::size_t i = 0; i < legs.size(); ++i) {
    Stage stage;
    for (const Pose2& pose : PosesAt(legs, i, start, allows_end)) {
      Arrival arrival{.pose = pose};
      // From the leg before, and over hints from those before that.
      for (std::size_t from = i + 1; from-- > 0;) {
        GoOn(stages[from], legs[i], radius, arrival);
        if (from > 0 && legs[from - 1].must_be_passed) break;
      }
      stage.push_back(std::move(arrival));
    }
    stages.push_back(std::move(stage));
  }
  const auto best = std::ranges::min_element(stages.back(), {}, &Arrival::cost);
  if (legs.empty() || best == stages.back().end()) return std::nullopt;
  return WayTo(*best);
}

namespace {

/// Across the line that halves the angle at `corner`, not far from it: a way that is planned anew
/// leads on, not back to it.
bool IsRound(const PlaneEdge& in, const PlaneEdge& out, const PlanePoint& at, Meters turn_radius) {
  constexpr double kNear = 3.0;  // turning radii
  const PlanePoint& corner = in.to_W;
  const PlanePoint onwards =
      (in.to_W - in.from_W).normalized() + (out.to_W - out.from_W).normalized();
  return (at - corner).norm() <= kNear * turn_radius.value() && (at - corner).dot(onwards) > 0.0;
}

}  // namespace

std::vector<PlanePoint> RestOfWay(const std::vector<PlanePoint>& places, const PlanePoint& at,
                                  Meters turn_radius) {
  constexpr double kUnderWay = 0.7;  // beside a leg, not before its begin
  std::size_t next = 0;
  double least = (places.front() - at).norm();
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double distance = (PlaneEdge{places[i], places[i + 1]}.Nearest(at) - at).norm();
    if (distance < kUnderWay * least) {
      least = distance;
      next = i + 1;
    }
  }
  while (next > 0 && next + 1 < places.size() &&
         IsRound({places[next - 1], places[next]}, {places[next], places[next + 1]}, at,
                 turn_radius)) {
    ++next;
  }
  return {places.begin() + static_cast<std::ptrdiff_t>(next), places.end()};
}

}  // namespace limpet
