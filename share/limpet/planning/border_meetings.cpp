// SPDX-License-Identifier: MIT
#include "limpet/planning/border_meetings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limpet/core/cross_product.hpp"
#include "limpet/planning/straightness.hpp"

namespace limpet {
namespace {

struct Circle {
  PlanePoint center;
  double radius = 0.0;
};

/// Where the straight line through `from` along the unit vector `along` meets a circle, as lengths.
void AddOnLine(const PlanePoint& from, const PlanePoint& along, const Circle& circle,
               std::vector<double>& lengths) {
  const double middle = (circle.center - from).dot(along);
  const double off2 = (circle.center - from).squaredNorm() - middle * middle;
  const double half2 = circle.radius * circle.radius - off2;
  if (half2 < 0.0) return;
  lengths.push_back(middle - std::sqrt(half2));
  lengths.push_back(middle + std::sqrt(half2));
}

/// The meetings of one arc or line with the elements of borders.
class Meetings {
 public:
  Meetings(const PlacedSegment& piece, std::vector<double>& lengths)
      : from_(piece.from.north, piece.from.east),
        along_(std::cos(piece.from.yaw), std::sin(piece.from.yaw)),
        curvature_(piece.segment.curvature),
        length_(piece.segment.length),
        is_straight_(IsStraight(curvature_)),
        lengths_(lengths) {
    if (!is_straight_) {
      arc_ = {from_ + PlanePoint(-along_.y(), along_.x()) / curvature_, 1.0 / std::abs(curvature_)};
    }
  }

  void WithSide(const PlaneEdge& side) {
    const PlanePoint way = side.to_W - side.from_W;
    const double side_length = way.norm();
    if (is_straight_) {
      const double cross = CrossOf(along_, way);
      if (std::abs(cross) <= 1e-12 * side_length) return;
      const PlanePoint to_side = side.from_W - from_;
      const double on_side = CrossOf(to_side, along_) / cross;
      if (on_side >= 0.0 && on_side <= 1.0) {
        Add(CrossOf(to_side, way) / cross);
      }
      return;
    }
    std::vector<double> on_line;
    AddOnLine(side.from_W, way / side_length, arc_, on_line);
    for (const double s : on_line) {
      if (s >= 0.0 && s <= side_length) AddPlace(side.from_W + s / side_length * way);
    }
  }

  void WithCircle(const Circle& circle) {
    if (is_straight_) {
      std::vector<double> on_line;
      AddOnLine(from_, along_, circle, on_line);
      for (const double s : on_line)
        Add(s);
      return;
    }
    const PlanePoint between = circle.center - arc_.center;
    const double distance = between.norm();
    if (distance <= 0.0) return;
    const double ahead =
        (distance * distance + arc_.radius * arc_.radius - circle.radius * circle.radius) /
        (2.0 * distance);
    const double aside2 = arc_.radius * arc_.radius - ahead * ahead;
    if (aside2 < 0.0) return;
    const PlanePoint unit = between / distance;
    const PlanePoint aside = std::sqrt(aside2) * PlanePoint(-unit.y(), unit.x());
    AddPlace(arc_.center + ahead * unit + aside);
    AddPlace(arc_.center + ahead * unit - aside);
  }

 private:
  void Add(double s) {
    if (s > 0.0 && s < length_) lengths_.push_back(s);
  }
  /// A place on the arc: every time that it comes past.
  void AddPlace(const PlanePoint& place) {
    const PlanePoint from_center = curvature_ * (place - arc_.center);
    const double full = 2.0 * std::numbers::pi;
    const double heading = std::atan2(from_center.x(), -from_center.y());
    const double turned = std::remainder(heading - std::atan2(along_.y(), along_.x()), full);
    const double ahead = curvature_ > 0.0 ? turned : -turned;
    for (double angle = ahead < 0.0 ? ahead + full : ahead; angle * arc_.radius < length_;
         angle += full) {
      Add(angle * arc_.radius);
    }
  }

  PlanePoint from_, along_;
  double curvature_, length_;
  bool is_straight_;
  Circle arc_;
  std::vector<double>& lengths_;
};

}  // namespace

void AddMeetings(const PlacedSegment& piece, const SimplePolygon& polygon, double distance,
                 std::vector<double>& lengths) {
  const double half = 0.5 * piece.segment.length;
  const Pose2 middle = Advance(piece.from, {.curvature = piece.segment.curvature, .length = half});
  const PlanePoint center(middle.north, middle.east);
  Meetings meetings(piece, lengths);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlaneEdge side = polygon.Edge(i);
    constexpr double kSlack = 1e-6;
    if ((side.Nearest(center) - center).norm() > half + distance + kSlack) continue;
    if (distance <= 0.0) {
      meetings.WithSide(side);
      continue;
    }
    const PlanePoint way = (side.to_W - side.from_W).normalized();
    const PlanePoint aside = distance * PlanePoint(-way.y(), way.x());
    meetings.WithSide({side.from_W + aside, side.to_W + aside});
    meetings.WithSide({side.from_W - aside, side.to_W - aside});
    meetings.WithCircle({side.from_W, distance});
    meetings.WithCircle({side.to_W, distance});
  }
}

}  // namespace limpet
