// SPDX-License-Identifier: MIT
#include "limpet/planning/dubins_path.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "limpet/core/require.hpp"
#include "limpet/planning/dubins_word.hpp"

namespace limpet {
namespace {

constexpr double kSameCurvature = 1e-12;

DubinsPath PathOf(const Pose2& from, const DubinsWord& word) {
  DubinsPath path(from);
  for (const PathSegment& segment : word.segments) {
    path.Append(segment);
  }
  return path;
}

}  // namespace

DubinsPath::DubinsPath(const Pose2& start, const std::vector<PathSegment>& segments)
    : start_(start) {
  for (const PathSegment& segment : segments) {
    Append(segment);
  }
}

void DubinsPath::Append(PathSegment segment) {
  LIMPET_REQUIRE(segment.length >= 0.0, "a segment of negative length");
  if (segment.length == 0.0) {
    return;
  }
  length_ += segment.length;
  if (!segments_.empty() &&
      std::abs(segments_.back().curvature - segment.curvature) < kSameCurvature) {
    segments_.back().length += segment.length;
  } else {
    segments_.push_back(segment);
  }
}

void DubinsPath::Append(const DubinsPath& next) {
  for (const PathSegment& segment : next.segments_) {
    Append(segment);
  }
}

Pose2 DubinsPath::At(double s) const {
  Pose2 pose = start_;
  double left = std::max(0.0, s);
  for (const PathSegment& segment : segments_) {
    const double step = std::min(left, segment.length);
    pose = Advance(pose, {.curvature = segment.curvature, .length = step});
    left -= step;
    if (left <= 0.0) {
      break;
    }
  }
  return pose;
}

DubinsPath DubinsPath::Prefix(double length) const {
  DubinsPath prefix(start_);
  double left = std::max(0.0, length);
  for (const PathSegment& segment : segments_) {
    prefix.Append({.curvature = segment.curvature, .length = std::min(left, segment.length)});
    left = std::max(0.0, left - segment.length);
  }
  return prefix;
}

DubinsPath DubinsPath::Rest(double s) const {
  DubinsPath rest(At(s));
  double flown = std::max(0.0, s);
  for (const PathSegment& segment : segments_) {
    const double left = std::max(0.0, segment.length - flown);
    rest.Append({.curvature = segment.curvature, .length = left});
    flown = std::max(0.0, flown - segment.length);
  }
  return rest;
}

std::vector<DubinsPath> AllDubins(const Pose2& from, const Pose2& to, Meters radius) {
  std::vector<DubinsPath> paths;
  const DubinsWords words(from, to, radius);
  std::ranges::transform(words.all(), std::back_inserter(paths),
                         [&from](const DubinsWord& word) { return PathOf(from, word); });
  return paths;
}

DubinsPath ShortestDubins(const Pose2& from, const Pose2& to, Meters radius) {
  return PathOf(from, DubinsWords(from, to, radius).shortest());
}

HelmPath ToHelmPath(const DubinsPath& path, int id, const std::string& purpose) {
  return {.id = id,
          .north = path.start().north,
          .east = path.start().east,
          .yaw = path.start().yaw,
          .segments = path.segments(),
          .purpose = purpose};
}

}  // namespace limpet
