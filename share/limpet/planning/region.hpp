// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "limpet/planning/dubins_path.hpp"
#include "limpet/planning/dubins_word.hpp"
#include "limpet/planning/free_space.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// How far paths keep inside the operating region and off its keep-out zones.
struct KeptOff {
  Meters border{0.0};
  Meters zones{0.0};
  friend bool operator==(const KeptOff&, const KeptOff&) = default;
};

/// The operating region: the survey area and the margin around it, or the region that the area
/// names, less its keep-out zones and the obstacles found. The vehicle never leaves it.
class Region {
 public:
  explicit Region(const SurveyArea& area) : Region(area, Meters(0.0)) {}
  /// Smaller all around by `allowance`, as far as there is a margin. REQUIRES: no ProblemOf(area).
  /// `obstacles` are fences to keep out of, as far off as they say.
  Region(const SurveyArea& area, Meters allowance, std::vector<Fence> obstacles = {});
  Region(const SurveyArea& area, const KeptOff& kept_off, std::vector<Fence> obstacles);

  [[nodiscard]] bool Contains(const PlanePoint& at) const;
  [[nodiscard]] bool Contains(const Pose2& pose) const {
    return Contains(PlanePoint(pose.north, pose.east));
  }
  /// Exact for arcs and lines, not sampled.
  [[nodiscard]] bool Contains(const DubinsPath& path) const;
  [[nodiscard]] bool Contains(const Pose2& from, const PathSegment& segment) const;
  [[nodiscard]] bool Contains(const Pose2& from, const DubinsWord& word) const;
  /// A full turn of `radius` to port or to starboard stays inside: the vehicle, which cannot stop
  /// or back up, can always go on from here.
  [[nodiscard]] bool IsRecoverable(const Pose2& pose, Meters radius) const;
  /// How far the better of the two turning circles reaches outside [m]; 0 if recoverable.
  [[nodiscard]] double Deficit(const Pose2& pose, Meters radius) const;
  /// Whether a vehicle at `from` may do `segment`: inside and recoverable at its end or, for one
  /// that drifted out, at least no worse off than before.
  [[nodiscard]] bool Allows(const Pose2& from, const PathSegment& segment, Meters radius) const;
  /// How far a place is from the nearest border of region or zone [m]; negative outside.
  [[nodiscard]] double Clearance(const PlanePoint& at) const;
  /// How far a place is from the nearest zone or obstacle [m]; infinite without any.
  [[nodiscard]] double ZoneClearance(const PlanePoint& at) const;
  /// How far `pose` is outside [m], 0 inside.
  [[nodiscard]] double Outside(const Pose2& pose) const;
  /// Whether `path` enters a keep-out zone or an obstacle; the region's own border is not asked
  /// for.
  [[nodiscard]] bool EntersZone(const DubinsPath& path) const;
  /// True for a place in a zone.
  [[nodiscard]] bool IsInZone(const PlanePoint& at) const;

  /// The shortest word to `to` that stays inside; nothing if none does. Allocates nothing.
  [[nodiscard]] std::optional<DubinsWord> ShortestWordInside(const Pose2& from, const Pose2& to,
                                                             Meters radius) const;
  /// The path joined to a shortest word to `to` that stays inside, or the shortest word of all if
  /// none does.
  [[nodiscard]] DubinsPath ShortestInside(const Pose2& from, const Pose2& to, Meters radius) const;

  /// What is inside; null for a rectangle without zones.
  [[nodiscard]] const FreeSpace* free_space() const { return free_.get(); }
  /// Differs between regions with other obstacles; 0 without any.
  [[nodiscard]] std::size_t obstacle_mark() const { return obstacle_mark_; }
  /// Way points from a start outside to the area, as the mission gives them.
  [[nodiscard]] const std::vector<PlanePoint>& transit() const { return transit_; }

  /// The box around it.
  [[nodiscard]] double north_min() const { return north_min_; }
  [[nodiscard]] double north_max() const { return north_max_; }
  [[nodiscard]] double east_min() const { return east_min_; }
  [[nodiscard]] double east_max() const { return east_max_; }

 private:
  [[nodiscard]] bool IsInRectangle(const Pose2& from, const PathSegment& segment) const;

  double north_min_, north_max_, east_min_, east_max_;
  std::shared_ptr<const FreeSpace> free_;   ///< null: the rectangle is all
  std::shared_ptr<const FreeSpace> zones_;  ///< what is in no zone; null without zones
  std::vector<PlanePoint> transit_;
  std::size_t obstacle_mark_ = 0;
};

}  // namespace limpet
