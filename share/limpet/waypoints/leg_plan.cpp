// SPDX-License-Identifier: MIT
#include "limpet/waypoints/leg_plan.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {
namespace {

/// A place and a heading as a vehicle sees them that begins to turn: to its right, ahead.
struct Offset {
  double right = 0.0, ahead = 0.0;
};

/// Part of a circle, by the headings on it [rad]; its centre is to starboard of who turns to
/// starboard.
struct TurnArc {
  Offset center;
  double radius = 0.0;
  double begin = 0.0, end = 0.0;
};

/// By how much a vehicle swings off its heading before a loop about `center`: to where the swing's
/// circle and the loop have a tangent in common.
double SwingTo(const Offset& center, double radius) {
  const double right = center.right - radius;  // of the centre of the swing's circle
  const double distance = std::hypot(right, center.ahead);
  // At a bias of one radius there is no swing, but for a rounding that is none the other way.
  return std::max(
      0.0, std::atan2(right, center.ahead) + std::asin(std::min(1.0, 2.0 * radius / distance)));
}

/// Unless it is where the last one is: arcs may have no length, and may touch.
void AddPoint(const Offset& point, std::vector<Offset>& points) {
  constexpr double kNone = 0.01;  // [m]
  const Offset& last = points.back();
  if (std::hypot(point.right - last.right, point.ahead - last.ahead) > kNone) {
    points.push_back(point);
  }
}

/// Points of an arc, `gap` [rad] apart at most.
void AddArc(const TurnArc& arc, double gap, std::vector<Offset>& points) {
  const double side = arc.end >= arc.begin ? -1.0 : 1.0, swept = arc.end - arc.begin;
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(swept) / gap - 1e-9)));
  for (int i = 0; i <= steps; ++i) {
    const double heading = arc.begin + swept * i / steps;
    AddPoint({.right = arc.center.right + side * arc.radius * std::cos(heading),
              .ahead = arc.center.ahead - side * arc.radius * std::sin(heading)},
             points);
  }
}

/// A turn about whose loop goes to port, from the origin, heading ahead, back to it.
std::vector<Offset> TurnAbout(const LegTurn& turn, double gap) {
  const double radius = turn.radius, off = turn.bias * radius;
  const double nearer = radius - std::abs(off);
  const double ahead = std::sqrt(4.0 * radius * radius - nearer * nearer);
  const Offset loop{.right = off, .ahead = ahead};
  const double first = SwingTo(loop, radius);
  const double last = -std::numbers::pi - SwingTo({.right = -off, .ahead = ahead}, radius);
  std::vector<Offset> points{{}};
  AddArc({{.right = radius}, radius, 0.0, first}, gap, points);
  AddArc({loop, radius, first, last}, gap, points);
  AddArc({{.right = -radius}, radius, last, -std::numbers::pi}, gap, points);
  return points;
}

}  // namespace

void LegPlan::Lay(const MapPoint& center, const BearingAndDistance& leg) {
  constexpr double kShortest = 1.0;
  const double half = 0.5 * std::max(kShortest, leg.distance);
  ends_ = {Project(center, {.bearing = leg.bearing, .distance = -half}),
           Project(center, {.bearing = leg.bearing, .distance = half})};
}

MapPoint LegPlan::center() const {
  return {.x = 0.5 * (ends_[0]->x + ends_[1]->x), .y = 0.5 * (ends_[0]->y + ends_[1]->y)};
}

std::vector<MapPoint> LegPlan::TurnPoints(std::size_t end) const {
  const LegTurn& turn = turns_.at(end);
  const MapPoint& from = *ends_.at(end);
  const double heading = BearingTo(*ends_.at(1 - end), from);
  const MapPoint begin = Project(from, {.bearing = heading, .distance = turn.extension});
  const double starboard = heading + 0.5 * std::numbers::pi;
  const double side = turn.is_port ? 1.0 : -1.0;
  std::vector<MapPoint> points;
  LegTurn flown = turn;
  flown.radius = std::max(least_radius_, turn.radius);
  for (const Offset& at : TurnAbout(flown, point_gap_)) {
    points.push_back(Project(Project(begin, {.bearing = heading, .distance = at.ahead}),
                             {.bearing = starboard, .distance = side * at.right}));
  }
  if (turn.extension > 0.0) points.push_back(from);
  return points;
}

}  // namespace limpet
