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

/// By how much a vehicle swings off its heading before a loop whose centre lies `off` to the right
/// of its way and `ahead`: to where the swing's circle and the loop have a tangent in common.
double SwingTo(double off, double ahead, double radius) {
  const double right = off - radius;  // of the centre of the swing's circle
  const double distance = std::hypot(right, ahead);
  // At a bias of one radius there is no swing, but for a rounding that is none the other way.
  return std::max(0.0,
                  std::atan2(right, ahead) + std::asin(std::min(1.0, 2.0 * radius / distance)));
}

/// Unless it is where the last one is: arcs may have no length, and may touch.
void AddPoint(const Offset& point, std::vector<Offset>& points) {
  constexpr double kNone = 0.01;  // [m]
  const Offset& last = points.back();
  if (std::hypot(point.right - last.right, point.ahead - last.ahead) > kNone) {
    points.push_back(point);
  }
}

/// Points of an arc about `center`, by the headings on it from `begin` to `end` [rad]; the centre
/// is to starboard of who turns to starboard.
void AddArc(const Offset& center, double radius, double begin, double end, double gap,
            std::vector<Offset>& points) {
  const double side = end >= begin ? -1.0 : 1.0;
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(end - begin) / gap - 1e-9)));
  for (int i = 0; i <= steps; ++i) {
    const double heading = begin + (end - begin) * i / steps;
    AddPoint({.right = center.right + side * radius * std::cos(heading),
              .ahead = center.ahead - side * radius * std::sin(heading)},
             points);
  }
}

/// A turn about whose loop goes to port, from the origin, heading ahead, back to it.
std::vector<Offset> TurnAbout(double radius, double bias, double gap) {
  const double off = bias * radius;
  const double nearer = radius - std::abs(off);
  const double ahead = std::sqrt(4.0 * radius * radius - nearer * nearer);
  const double first = SwingTo(off, ahead, radius), last = SwingTo(-off, ahead, radius);
  std::vector<Offset> points{{}};
  AddArc({.right = radius}, radius, 0.0, first, gap, points);
  AddArc({.right = off, .ahead = ahead}, radius, first, -std::numbers::pi - last, gap, points);
  AddArc({.right = -radius}, radius, -std::numbers::pi - last, -std::numbers::pi, gap, points);
  return points;
}

}  // namespace

void LegPlan::Lay(const MapPoint& center, double bearing, double length) {
  constexpr double kShortest = 1.0;
  const double half = 0.5 * std::max(kShortest, length);
  ends_ = {Project(center, bearing, -half), Project(center, bearing, half)};
}

MapPoint LegPlan::center() const {
  return {.x = 0.5 * (ends_[0]->x + ends_[1]->x), .y = 0.5 * (ends_[0]->y + ends_[1]->y)};
}

std::vector<MapPoint> LegPlan::TurnPoints(std::size_t end) const {
  const LegTurn& turn = turns_.at(end);
  const MapPoint& from = *ends_.at(end);
  const double heading = BearingTo(*ends_.at(1 - end), from);
  const MapPoint begin = Project(from, heading, turn.extension);
  const double starboard = heading + 0.5 * std::numbers::pi;
  const double side = turn.is_port ? 1.0 : -1.0;
  std::vector<MapPoint> points;
  for (const Offset& at : TurnAbout(std::max(least_radius_, turn.radius), turn.bias, point_gap_)) {
    points.push_back(Project(Project(begin, heading, at.ahead), starboard, side * at.right));
  }
  if (turn.extension > 0.0) points.push_back(from);
  return points;
}

}  // namespace limpet
