// SPDX-License-Identifier: MIT
#include "limpet/safety/zone_watch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limpet/survey/inscribed_circle.hpp"
#include "limpet/survey/survey_shape.hpp"

namespace limpet {
namespace {

constexpr double kMostCircles = 16384.0;
constexpr double kFinest_m = 0.2;
constexpr double kSharpCorner_m = 1.0;

/// Distance between centres of a grid over the polygon's box [m].
double SpacingOver(const SimplePolygon& outline) {
  const PlanePoint extent = outline.high() - outline.low();
  return std::max(kFinest_m, std::sqrt(extent.x() * extent.y() / kMostCircles));
}

}  // namespace

ZoneWatch::Zone ZoneWatch::ZoneOf(const SimplePolygon& outline) {
  Zone zone{.outline = outline,
            .narrowest = std::min(kSharpCorner_m, InscribedRadius(outline)),
            .spacing = SpacingOver(outline),
            .circles = {}};
  const double half = 0.5 * zone.spacing;
  for (double north = outline.low().x() + half; north < outline.high().x(); north += zone.spacing) {
    for (double east = outline.low().y() + half; east < outline.high().y(); east += zone.spacing) {
      const PlanePoint centre(north, east);
      if (const double radius = outline.Depth(centre); radius > 0.0) {
        zone.circles.push_back({centre, radius});
      }
    }
  }
  return zone;
}

ZoneWatch::ZoneWatch(const SurveyArea& area) {
  const Expected<SurveyShape> shape = SurveyShape::Of(area);
  for (const SimplePolygon& zone : shape->zones()) {
    zones_.push_back(ZoneOf(zone));
  }
}

double ZoneWatch::Zone::HalfWidthAt(const PlanePoint& at) const {
  // The greatest circle may have its centre between those that are known.
  const double between = spacing / std::numbers::sqrt2;
  double half_width = narrowest;
  for (const Circle& circle : circles) {
    const bool holds = (circle.centre - at).norm() <= circle.radius + between;
    if (holds) half_width = std::max(half_width, circle.radius);
  }
  return half_width;
}

std::optional<double> ZoneWatch::ShareAt(const PlanePoint& at) const {
  std::optional<double> greatest;
  for (const Zone& zone : zones_) {
    const double depth = std::max(0.0, zone.outline.Depth(at));
    const double share = depth > 0.0 ? std::min(1.0, depth / zone.HalfWidthAt(at)) : 0.0;
    greatest = std::max(greatest.value_or(0.0), share);
  }
  return greatest;
}

}  // namespace limpet
