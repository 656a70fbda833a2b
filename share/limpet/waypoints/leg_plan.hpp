// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

#include "limpet/waypoints/map_geometry.hpp"

namespace limpet {

/// How a vehicle turns about beyond the end of a leg: a swing off its heading, a loop to the other
/// side, and a swing back, all on circles of one radius.
struct LegTurn {
  double radius = 15.0;    ///< [m]
  double extension = 0.0;  ///< straight on before it begins [m]
  double bias = 0.0;       ///< -1 to 1: the loop lies off the leg, by radii, to where it swings
  bool is_port = true;     ///< which way the loop goes round
};

/// A leg between two points that is travelled to and fro, with a turn beyond either end.
class LegPlan {
 public:
  void SetEnd(std::size_t end, const MapPoint& point) { ends_.at(end) = point; }
  /// The leg's middle, and the way from its first to its second end, of at least a metre.
  void Lay(const MapPoint& center, const BearingAndDistance& leg);
  [[nodiscard]] LegTurn& turn(std::size_t end) { return turns_.at(end); }
  [[nodiscard]] const LegTurn& turn(std::size_t end) const { return turns_.at(end); }
  /// No turn gets tighter than this [m].
  void SetLeastRadius(double radius) { least_radius_ = radius; }
  /// Sets the angle between two points of a turn [rad].
  void SetPointGap(double gap) { point_gap_ = gap; }

  /// Both ends are known. What follows REQUIRES it.
  [[nodiscard]] bool is_set() const { return ends_[0] && ends_[1]; }
  [[nodiscard]] const MapPoint& end(std::size_t index) const { return *ends_.at(index); }
  [[nodiscard]] MapPoint center() const;
  [[nodiscard]] double bearing() const { return BearingTo(*ends_[0], *ends_[1]); }
  [[nodiscard]] double length() const { return DistanceBetween(*ends_[0], *ends_[1]); }
  /// The way by which a vehicle that comes to this end leaves it on the opposite heading; ends
  /// there.
  [[nodiscard]] std::vector<MapPoint> TurnPoints(std::size_t end) const;

 private:
  std::array<std::optional<MapPoint>, 2> ends_;
  std::array<LegTurn, 2> turns_;
  double least_radius_ = 2.0;
  double point_gap_ = std::numbers::pi / 9.0;
};

}  // namespace limpet
