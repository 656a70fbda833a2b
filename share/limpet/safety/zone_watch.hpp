// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "limpet/survey/simple_polygon.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// How deep in a keep-out zone the vehicle is, by the zone's own size: in one of 3 m it is never
/// more than 1.5 m inside.
class ZoneWatch {
 public:
  ZoneWatch() = default;
  /// REQUIRES: no ProblemOf(area).
  explicit ZoneWatch(const SurveyArea& area);

  /// Distance to the zone's border as a share of the radius of its inscribed circle, the greatest
  /// of all zones; 0 outside, absent where there is no zone.
  [[nodiscard]] std::optional<double> ShareAt(const PlanePoint& at) const;

 private:
  struct Zone {
    SimplePolygon outline;
    double radius = 0.0;  ///< of its inscribed circle [m]
  };
  std::vector<Zone> zones_;
};

}  // namespace limpet
