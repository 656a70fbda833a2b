// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/planning/pose2.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// A start pose and the arcs and lines that follow it.
class DubinsPath {
 public:
  DubinsPath() = default;
  explicit DubinsPath(const Pose2& start, const std::vector<PathSegment>& segments = {});

  [[nodiscard]] const Pose2& start() const { return start_; }
  [[nodiscard]] const std::vector<PathSegment>& segments() const& { return segments_; }
  /// Of a temporary by value, so that a range-for over it is safe.
  [[nodiscard]] std::vector<PathSegment> segments() && { return std::move(segments_); }
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] Pose2 end() const { return At(length_); }

  /// The pose after `s` [m]; clamped to the path.
  [[nodiscard]] Pose2 At(double s) const;
  /// Adds a segment; one of the same curvature as the last lengthens that.
  /// REQUIRES: length >= 0. A length of 0 adds nothing.
  void Append(PathSegment segment);
  /// Adds the segments of a path that starts where this one ends.
  void Append(const DubinsPath& next);
  /// The first `length` metres.
  [[nodiscard]] DubinsPath Prefix(double length) const;
  /// What is left of it after `s` metres.
  [[nodiscard]] DubinsPath Rest(double s) const;

  /// Calls visit(pose, s) every `step` metres from `first_s` on, and at the end.
  template <class Visit>
  void Sample(double step, Visit visit, double first_s = 0.0) const {
    Pose2 from = start_;
    double done = 0.0, next = first_s;
    for (const PathSegment& segment : segments_) {
      for (; next < done + segment.length; next += step) {
        visit(Advance(from, {.curvature = segment.curvature, .length = next - done}), next);
      }
      from = Advance(from, segment);
      done += segment.length;
    }
    visit(from, done);
  }

 private:
  Pose2 start_;
  std::vector<PathSegment> segments_;
  double length_ = 0.0;
};

/// The shortest of the six words of [Dubins 1957] (LSL, RSR, LSR, RSL, LRL, RLR) from `from` to
/// `to` with turns of radius `radius`. REQUIRES: radius > 0.
[[nodiscard]] DubinsPath ShortestDubins(const Pose2& from, const Pose2& to, Meters radius);
/// Every word that exists, in the order above, unsorted: for choosing one that stays inside.
[[nodiscard]] std::vector<DubinsPath> AllDubins(const Pose2& from, const Pose2& to, Meters radius);

/// The path as the pilot and the log are told it.
[[nodiscard]] HelmPath ToHelmPath(const DubinsPath& path, int id, const std::string& purpose);

}  // namespace limpet
