// SPDX-License-Identifier: MIT
#include "limpet/helm/path_tracker.hpp"

#include <cmath>

namespace limpet {

void PathTracker::Follow(const Option& option) {
  travelled_ = Travelled();
  path_ = option.path;
  purpose_ = option.source;
  has_path_ = true;
  ++path_id_;
  const Pose2& start = path_.start();
  guidance_.SetPath({start.north, start.east, start.yaw}, path_.segments());
  steering_ = {.remaining = path_.length()};
}

void PathTracker::Drop() {
  travelled_ = Travelled();
  has_path_ = false;
  path_ = DubinsPath();
}

std::optional<Guidance> PathTracker::Guide(const NavState& nav) {
  if (!has_path_) {
    return std::nullopt;
  }
  steering_ = guidance_.Update({nav.north, nav.east}, std::hypot(nav.u, nav.v));
  return Guidance{.course = steering_.course,
                  .turn_rate = steering_.turn_rate,
                  .cross_track = steering_.cross_track,
                  .remaining = steering_.remaining,
                  .purpose = purpose_};
}

Pose2 PathTracker::JoiningPose(const NavState& nav, double near) const {
  // Beyond its end a path says nothing of where the vehicle is.
  const bool is_on_path = has_path_ && steering_.progress < path_.length();
  if (is_on_path && std::abs(steering_.cross_track) < near) {
    return path_.At(steering_.progress);
  }
  return {.north = nav.north, .east = nav.east, .yaw = nav.yaw};
}

}  // namespace limpet
