// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "limpet/survey/simple_polygon.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// How deep in a keep-out zone the vehicle is, by the zone's own width there: in one of 3 m, and in
/// an arm of 3 m of a wide one, it is never more than 1.5 m inside.
class ZoneWatch {
 public:
  ZoneWatch() = default;
  /// REQUIRES: no ProblemOf(area).
  explicit ZoneWatch(const SurveyArea& area);

  /// Distance to the zone's border as a share of half the zone's width there: the radius of the
  /// greatest circle inside it that holds the place. The greatest share of all zones; 0 outside,
  /// absent where there is no zone.
  [[nodiscard]] std::optional<double> ShareAt(const PlanePoint& at) const;

 private:
  struct Circle {
    PlanePoint centre;
    double radius = 0.0;
  };
  struct Zone {
    SimplePolygon outline;
    double narrowest = 0.0;       ///< a radius of less counts as this [m]: in sharp corners
    double spacing = 0.0;         ///< of the circles' centres [m]
    std::vector<Circle> circles;  ///< inside, from a grid over it

    [[nodiscard]] double HalfWidthAt(const PlanePoint& at) const;
  };
  [[nodiscard]] static Zone ZoneOf(const SimplePolygon& outline);
  std::vector<Zone> zones_;
};

}  // namespace limpet
