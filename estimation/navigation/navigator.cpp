// SPDX-License-Identifier: MIT
#include "estimation/navigation/navigator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limpet/core/require.hpp"

namespace limpet {

Navigator::Navigator(const NavigatorParams& params)
    : params_(params), gate_(params.velocity_gate), track_(params.odometry) {}

void Navigator::AddAttitude(const AttitudeEstimate& attitude) { track_.AddAttitude(attitude); }

void Navigator::AddVelocity(double t, const std::optional<Eigen::Vector3d>& v_dvl_B) {
  const bool is_good = v_dvl_B && gate_.Accepts(t, *v_dvl_B);
  track_.AddVelocity(t, is_good ? v_dvl_B : std::nullopt);
}

void Navigator::AddDepth(double t, double depth) {
  if (track_.is_empty() || !std::isfinite(depth)) {
    return;
  }
  const double error = depth - (track_.At(t).X_DB.p_WB.z() + p_WD_.z());
  p_WD_.z() += 0.05 * error;
}

void Navigator::AddGps(double t, const Eigen::Vector2d& p_W, double sd) {
  if (track_.is_empty() || !p_W.allFinite() || !(sd > 0.0)) {
    return;
  }
  ++fix_count_;
  const Eigen::Vector2d offset = p_W - track_.At(t).X_DB.p_WB.head<2>();
  p_WD_.head<2>() += (offset - p_WD_.head<2>()) / fix_count_;
  if (fix_count_ == 1) {
    first_p_WD_ = p_WD_;
  }
}

void Navigator::AddFrame(const FrameDetections& frame) { waiting_.push_back(frame); }

void Navigator::Advance(double now) {
  if (track_.is_empty() || !has_started()) {
    waiting_.clear();
    return;
  }
  std::ranges::stable_sort(waiting_, {}, &FrameDetections::t);
  const double head = now - params_.frame_wait.value();
  auto frame = waiting_.begin();
  for (; frame != waiting_.end() && frame->t <= head; ++frame) {
    posed_.push_back({*frame, Estimate(frame->t).X_WB, std::vector<int>(frame->boxes.size(), -1)});
  }
  waiting_.erase(waiting_.begin(), frame);
  track_.DropBefore(now - 10.0);
}

NavigatorEstimate Navigator::Estimate(double t) const {
  LIMPET_REQUIRE(has_started(), "no fix yet");
  const TrackPose track = track_.At(t);
  NavigatorEstimate estimate{
      .t = t, .X_WB = track.X_DB, .v_B = track.v_B, .yaw_rate = track.yaw_rate};
  estimate.X_WB.p_WB += p_WD_;
  estimate.X_WB.yaw = WrapAngle(estimate.X_WB.yaw);
  return estimate;
}

Pose Navigator::DeadReckoned(double t) const {
  Pose pose = Estimate(t).X_WB;
  pose.p_WB.head<2>() += first_p_WD_.head<2>() - p_WD_.head<2>();
  return pose;
}

std::vector<PosedFrame> Navigator::TakeFrames() { return std::exchange(posed_, {}); }

}  // namespace limpet
