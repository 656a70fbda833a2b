// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limpet/core/interval.hpp"
#include "limpet/core/units.hpp"
#include "limpet/planning/pose2.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// Line-of-sight guidance along arcs and lines (Fossen 2011 section 12.5, eq. 12.78): the course
/// that meets the path one look-ahead on, and the turn rate that keeps the vehicle on an arc.
///
/// Progress never goes back and is sought only just ahead, so a path that crosses itself is
/// followed in its own order. Beyond its end the path goes straight on. SetPath may allocate;
/// Update does not.
class LineOfSight {
 public:
  struct Params {
    Meters lookahead{1.5};  ///< shorter: stiffer
    Meters search{2.0};     ///< how far ahead of the last progress the nearest point is sought
    Radians max_intercept = Radians::FromTextUnit(60.0);  ///< greatest angle towards the path
    /// The turn rate is that of the path this much later: makes up for the vehicle's lag.
    Seconds preview{0.35};
  };

  struct Steering {
    double progress = 0.0;     ///< along the path [m]
    double remaining = 0.0;    ///< to its end [m], 0 beyond
    double cross_track = 0.0;  ///< of the vehicle, positive to starboard of the path [m]
    double path_course = 0.0;  ///< of the path at `progress` [rad], in (-pi, pi]
    double course = 0.0;       ///< to steer [rad], in (-pi, pi]
    double turn_rate = 0.0;    ///< feed-forward [rad/s], starboard positive
    bool has_arrived = false;  ///< at or beyond the end
  };

  LineOfSight() : LineOfSight(Params{}) {}
  explicit LineOfSight(const Params& params) : params_(params) {}

  /// Takes a new path and forgets all progress. Segments without length are passed over.
  void SetPath(const Pose2& start, const std::vector<PathSegment>& segments);
  void SetPath(const HelmPath& path) { SetPath({path.north, path.east, path.yaw}, path.segments); }

  /// For a vehicle at `place_W` (north, east) with `speed` over ground [m/s]. REQUIRES: has_path().
  [[nodiscard]] Steering Update(const Eigen::Vector2d& place_W, double speed);

  [[nodiscard]] bool has_path() const { return !pieces_.empty(); }
  [[nodiscard]] double length() const { return length_; }
  /// Where the path is at `progress` >= 0; its yaw is not wrapped. REQUIRES: has_path().
  [[nodiscard]] Pose2 At(double progress) const;

 private:
  struct Piece {
    Pose2 start;
    double curvature = 0.0;
    double length = 0.0;
    double begin = 0.0;  ///< progress at its start
  };
  /// Where within a stretch of its own length a piece is nearest to a point. Exact for stretches
  /// shorter than a full turn.
  [[nodiscard]] static double Nearest(const Piece& piece, const Eigen::Vector2d& place_W,
                                      const Interval& stretch);
  [[nodiscard]] double NearestAhead(const Eigen::Vector2d& place_W) const;
  [[nodiscard]] double TurnRate(double cross_track, MetersPerSecond speed) const;

  Params params_;
  std::vector<Piece> pieces_;  // the last one is the straight run-out
  double length_ = 0.0;
  double progress_ = 0.0;
};

}  // namespace limpet
