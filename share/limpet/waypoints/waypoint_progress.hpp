// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "limpet/shapes/shape.hpp"

namespace limpet {

/// When a waypoint counts as reached [m].
struct CaptureRule {
  double capture_radius = 3.0;
  /// The distance has begun to grow again within this: reached, too. No more than the capture
  /// radius: off.
  double slip_radius = 15.0;
  bool captures_at_line = false;  ///< beyond the line across the leg's end: reached, too
};

/// How far a vehicle has come on a list of waypoints.
class WaypointProgress {
 public:
  enum class Step { kUnderway, kAdvanced, kCycled, kCompleted };

  /// Begins at the first of them.
  void SetPoints(std::vector<MapPoint> points);
  /// Other places for as many points, on the way as it is. REQUIRES: as many.
  void MovePoints(std::vector<MapPoint> points);
  void Append(const MapPoint& point) { points_.push_back(point); }
  /// Points and rounds that `former` has reached on another list count here, too.
  void CountOn(const WaypointProgress& former);
  /// The last one first, from the new first one on.
  void Reverse();
  /// No effect if there is no such point.
  void SetIndex(std::size_t index);
  /// How often the list is travelled after the first time; nothing: for ever.
  void SetRepeats(std::optional<int> repeats) { repeats_ = repeats; }
  /// Begins from the first point again, as if nothing had been travelled.
  void Restart();
  /// The next distance is not compared with those before: the vehicle went elsewhere.
  void ForgetApproach() { nearest_.reset(); }

  /// The vehicle is at `at`: goes on to the next point if this one is reached.
  Step Advance(const MapPoint& at, const CaptureRule& rule);

  [[nodiscard]] const std::vector<MapPoint>& points() const { return points_; }
  [[nodiscard]] std::size_t index() const { return index_; }
  /// REQUIRES: there are points.
  [[nodiscard]] const MapPoint& next() const { return points_[index_]; }
  /// The point reached last, or where the way began; absent before the first Advance.
  [[nodiscard]] const std::optional<MapPoint>& previous() const { return previous_; }
  [[nodiscard]] std::optional<std::size_t> previous_index() const { return previous_index_; }
  [[nodiscard]] int cycles() const { return cycles_; }
  [[nodiscard]] int hits() const { return captures_ + slips_; }
  [[nodiscard]] int captures() const { return captures_; }
  [[nodiscard]] int slips() const { return slips_; }
  /// Nothing: for ever.
  [[nodiscard]] std::optional<int> repeats_left() const;

  /// What is left of this round [m]. REQUIRES: there are points.
  [[nodiscard]] double ToEndOfCycle(const MapPoint& at) const;
  /// What is left of all rounds [m]; nothing if they have no end.
  [[nodiscard]] std::optional<double> ToEnd(const MapPoint& at) const;

 private:
  [[nodiscard]] bool IsReached(const MapPoint& at, const CaptureRule& rule);

  std::vector<MapPoint> points_;
  std::size_t index_ = 0;
  std::optional<MapPoint> previous_;
  std::optional<std::size_t> previous_index_;
  std::optional<double> nearest_;  ///< least distance to the next point so far [m]
  std::optional<int> repeats_ = 0;
  int repeated_ = 0, cycles_ = 0, captures_ = 0, slips_ = 0;
};

}  // namespace limpet
