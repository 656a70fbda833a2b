// SPDX-License-Identifier: MIT
#include "estimation/navigation/track_watch.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/four_decimals.hpp"
#include "limpet/core/require.hpp"

namespace limpet {
namespace {

constexpr double kCompared = 5.0;  // [s] a shift changes slowly along the track

}  // namespace

void TrackWatch::Note(const std::vector<SmoothedPose>& newer) {
  for (const SmoothedPose& pose : newer) {
    told_.push_back(pose.X_WB);
  }
}

std::optional<TrackShift> TrackWatch::Compare(const std::vector<SmoothedPose>& track) {
  LIMPET_REQUIRE(track.size() >= told_.size(), "a track does not get shorter");
  double farthest = 0.0;
  for (std::size_t i = 0; i < told_.size(); ++i) {
    farthest = std::max(farthest, (track[i].X_WB.p_WB - told_[i].p_WB).norm());
  }
  if (farthest <= kNoticed) {
    return std::nullopt;
  }
  TrackShift shift;
  for (std::size_t i = 0; i < told_.size(); ++i) {
    const bool is_end = i + 1 == told_.size();
    if (is_end || shift.steps.empty() || track[i].t - shift.steps.back()[0] >= kCompared) {
      const Eigen::Vector3d moved = track[i].X_WB.p_WB - told_[i].p_WB;
      const double turned = WrapAngle(track[i].X_WB.yaw - told_[i].yaw);
      shift.steps.push_back({track[i].t, ToFourDecimals(moved.x()), ToFourDecimals(moved.y()),
                             ToFourDecimals(moved.z()), ToFourDecimals(turned)});
    }
    told_[i] = track[i].X_WB;
  }
  return shift;
}

}  // namespace limpet
