// SPDX-License-Identifier: MIT
// The estimator behind pNav and `limpet nav`: measurements in, poses and landmarks out.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "estimation/association/detection.hpp"
#include "estimation/attitude/attitude_filter.hpp"
#include "estimation/navigation/odometry_track.hpp"
#include "estimation/navigation/velocity_gate.hpp"
#include "limpet/core/frames.hpp"

namespace limpet {

struct NavigatorParams {
  OdometryParams odometry;
  VelocityGateParams velocity_gate;
  Seconds frame_wait{0.6};  ///< boxes of a frame are waited for this long after its exposure
};

/// Pose and velocity at `t`, as known now; 1-sigma of the pose.
struct NavigatorEstimate {
  double t = 0.0;
  Pose X_WB;
  Eigen::Vector3d v_B = Eigen::Vector3d::Zero();
  double yaw_rate = 0.0;
  Eigen::Vector3d sd_p = Eigen::Vector3d::Zero();
  double sd_yaw = 0.0;
};

/// A frame with the pose at its exposure and, per box, the landmark it shows or -1.
struct PosedFrame {
  FrameDetections detections;
  Pose X_WB;
  std::vector<int> landmarks;
};

/// Measurements come in order of arrival, each with its time of measurement [s]; `Advance` then
/// works off what is complete.
class Navigator {
 public:
  explicit Navigator(const NavigatorParams& params);

  void AddAttitude(const AttitudeEstimate& attitude);
  /// Velocity of the DVL in body axes [m/s]; nothing without lock.
  void AddVelocity(double t, const std::optional<Eigen::Vector3d>& v_dvl_B);
  void AddDepth(double t, double depth);
  /// Fix in W [m] with its 1-sigma.
  void AddGps(double t, const Eigen::Vector2d& p_W, double sd);
  void AddFrame(const FrameDetections& frame);
  void Advance(double now);

  /// True once a fix has said where in W the vehicle is.
  [[nodiscard]] bool has_started() const { return fix_count_ > 0; }
  /// REQUIRES: has_started().
  [[nodiscard]] NavigatorEstimate Estimate(double t) const;
  /// Bottom track alone from the first fix. REQUIRES: has_started().
  [[nodiscard]] Pose DeadReckoned(double t) const;
  /// Frames posed since the last call, in order of exposure.
  [[nodiscard]] std::vector<PosedFrame> TakeFrames();

 private:
  NavigatorParams params_;
  VelocityGate gate_;
  OdometryTrack track_;
  std::vector<FrameDetections> waiting_;
  std::vector<PosedFrame> posed_;
  int fix_count_ = 0;
  Eigen::Vector3d p_WD_ = Eigen::Vector3d::Zero();  ///< of the track's frame in W
  Eigen::Vector3d first_p_WD_ = Eigen::Vector3d::Zero();
};

}  // namespace limpet
