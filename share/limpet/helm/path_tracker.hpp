// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "limpet/helm/situation.hpp"
#include "limpet/planning/line_of_sight.hpp"
#include "limpet/planning/option.hpp"

namespace limpet {

/// The path in force and how far the vehicle has come on it.
class PathTracker {
 public:
  void Follow(const Option& option);
  void Drop();
  /// Where to steer; nothing without a path. Takes note of the progress.
  [[nodiscard]] std::optional<Guidance> Guide(const NavState& nav);

  [[nodiscard]] bool has_path() const { return has_path_; }
  /// The path that is followed; empty without one.
  [[nodiscard]] const DubinsPath& path() const { return path_; }
  /// Number of the path followed last; counts from 1.
  [[nodiscard]] int path_id() const { return path_id_; }
  [[nodiscard]] const LineOfSight::Steering& steering() const { return steering_; }
  /// Length of all paths followed so far, as far as they were flown [m].
  [[nodiscard]] double Travelled() const {
    return travelled_ + (has_path_ ? steering_.progress : 0.0);
  }
  /// Where a new path should start: on the present one while the vehicle is within `near` metres of
  /// it, so that the course has no step; else where the vehicle is.
  [[nodiscard]] Pose2 JoiningPose(const NavState& nav, double near) const;

 private:
  DubinsPath path_;
  std::string purpose_;  ///< source of the option that was chosen
  bool has_path_ = false;
  LineOfSight guidance_;
  LineOfSight::Steering steering_;
  double travelled_ = 0.0;  ///< along finished paths [m]
  int path_id_ = 0;
};

}  // namespace limpet
