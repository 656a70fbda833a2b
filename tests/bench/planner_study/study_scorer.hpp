// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "limpet/core/camera_model.hpp"
#include "limpet/core/random.hpp"
#include "limpet/planning/pose2.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// Path length at which a share of samples was first reached.
class LevelLog {
 public:
  void Note(double path, double share);
  /// [m], or nothing if never.
  [[nodiscard]] std::optional<double> PathAt(double level) const;
  [[nodiscard]] double share() const { return steps_.empty() ? 0.0 : steps_.back().share; }

 private:
  struct Step {
    double path, share;
  };
  std::vector<Step> steps_;
};

/// Judges a flight by samples of its own, with nothing of the planner's rules: the seabed by one
/// random point per 0.25 m cell, the band by one object per cell at a random height, seen well when
/// at least 60 % of its disc is inside the image in at least three frames.
class StudyScorer {
 public:
  StudyScorer(const SurveyArea& area, double altitude, const CameraModel& camera, Random& random);
  /// One frame of a level camera, `path` metres into the flight.
  void Frame(const Pose2& at, double path);

  [[nodiscard]] const LevelLog& seabed() const { return seabed_log_; }
  [[nodiscard]] const LevelLog& band() const { return band_log_; }

 private:
  struct Sample {
    float north, east, height;
    int frames;
  };
  [[nodiscard]] bool ShowsDisc(double forward, double starboard, double height) const;

  double altitude_, tan_across_, tan_along_;
  double north_min_, east_min_;
  int rows_, columns_;
  std::vector<Sample> bottom_, objects_;
  long bottom_seen_ = 0, objects_seen_ = 0;
  LevelLog seabed_log_, band_log_;
};

}  // namespace limpet
