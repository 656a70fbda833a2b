// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/core/units.hpp"
#include "limpet/shapes/shape.hpp"

namespace limpet {

/// Way and time of legs, as they would be straight at the speed that is wanted, and as they were.
struct LegSums {
  double straight_m = 0.0, travelled_m = 0.0;
  double straight_s = 0.0, travelled_s = 0.0;

  /// Straight by travelled; 0 where nothing was travelled.
  [[nodiscard]] double DistanceEfficiency() const {
    return travelled_m > 0.0 ? straight_m / travelled_m : 0.0;
  }
  [[nodiscard]] double TimeEfficiency() const {
    return travelled_s > 0.0 ? straight_s / travelled_s : 0.0;
  }
};

/// How directly a vehicle travels from waypoint to waypoint. A leg counts from one waypoint reached
/// to the next, if nothing has spoilt it meanwhile.
class LegOdometer {
 public:
  /// The vehicle is at `at`.
  void Move(const MapPoint& at);
  /// A waypoint is reached, for which `speed` was wanted [m/s]; true if the leg counts.
  bool Reach(const MapPoint& at, Seconds now, double speed);
  /// The present leg does not count, e.g. as another speed is wanted now.
  void Spoil() { is_spoilt_ = true; }
  /// Spoils the leg as Spoil does, and what is travelled until the next Move does not count either.
  void Pause() { Spoil(), last_.reset(); }

  /// Way travelled since the last waypoint [m].
  [[nodiscard]] double travelled_m() const { return travelled_m_; }
  /// The last leg that counted, and all of them.
  [[nodiscard]] const LegSums& leg() const { return leg_; }
  [[nodiscard]] const LegSums& all() const { return all_; }

 private:
  std::optional<MapPoint> last_, from_;
  Seconds since_{0.0};
  double travelled_m_ = 0.0;
  bool is_spoilt_ = true;  ///< the first leg began nowhere
  LegSums leg_, all_;
};

}  // namespace limpet
