// SPDX-License-Identifier: MIT
// The estimator behind pNav and `limpet nav`: measurements in, poses and landmarks out.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "estimation/association/object_tracker.hpp"
#include "estimation/attitude/attitude_filter.hpp"
#include "estimation/navigation/former_session.hpp"
#include "estimation/navigation/odometry_track.hpp"
#include "estimation/navigation/velocity_gate.hpp"
#include "estimation/smoothing/arrow_smoother.hpp"
#include "limpet/core/frames.hpp"

namespace limpet {

struct NavigatorParams {
  OdometryParams odometry;
  VelocityGateParams velocity_gate;
  CameraModel camera;
  ObjectTrackerParams objects;
  ArrowParams smoother{.converged_decrease = 1e-6};
  Seconds frame_wait{0.6};    ///< boxes of a frame are waited for this long after its exposure
  Seconds node_period{1.0};   ///< longest time between poses of the chain
  Meters node_distance{0.5};  ///< and longest way
  Meters depth_sigma{0.015};  ///< of the depths of one second together, bias included
  Radians tilt_sigma{0.0047};
  Meters start_sigma{5.0};          ///< of the first position, before any fix
  Seconds errors_period{1800.0};    ///< slow errors of the odometry are estimated anew after this
  Seconds yaw_bias_memory{7200.0};  ///< after which the bias of the yaw rate is another
  Seconds gps_correlation{240.0};   ///< fixes this far apart are worth two: twice the error's own
  Seconds fix_wait{0.0};            ///< start at the origin when no fix comes in time; 0: never
  MatchingParams session;
};

/// Pose and velocity at `t`, as known now; 1-sigma of the pose.
struct NavigatorEstimate {
  double t = 0.0;
  Pose X_WB;
  Eigen::Vector3d v_B = Eigen::Vector3d::Zero();
  double yaw_rate = 0.0;
  std::optional<double> altitude;  ///< of the body origin above the seabed [m], if measured lately
  std::optional<double> velocity_age;  ///< of `v_B` [s], in a dropout of the DVL
  Eigen::Vector3d sd_p = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance_p = Eigen::Matrix3d::Zero();  ///< of the position in W
  double sd_yaw = 0.0;
};

/// A frame with the pose at its exposure and, per box, the landmark it shows or -1.
struct PosedFrame {
  FrameDetections detections;
  Pose X_WB;
  std::optional<double> altitude;  ///< of the body origin above the seabed then [m]
  std::vector<int> landmarks;
};

struct LandmarkEstimate {
  int id = 0;
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  std::string color;
  int looks = 0;
  int prior_id = -1;
};

/// A pose of the chain, smoothed.
struct SmoothedPose {
  double t = 0.0;
  Pose X_WB;
};

/// What was refused, since the start.
struct NavigatorCounts {
  int velocities = 0, depths = 0, fixes = 0, late_frames = 0, stale_samples = 0, looks = 0;
};

/// Measurements come in order of arrival, each with its time of measurement [s]; `Advance` then
/// works off what is complete, in order of time: the chain's head stays `frame_wait` behind, and
/// dead reckoning leads from it to the present. Values that are not numbers are refused and
/// counted.
class Navigator {
 public:
  explicit Navigator(const NavigatorParams& params);

  void AddAttitude(const AttitudeEstimate& attitude);
  /// Velocity of the DVL in body axes [m/s]; nothing without lock.
  void AddVelocity(double t, const std::optional<Eigen::Vector3d>& v_dvl_B);
  /// Height of the DVL above the seabed [m]; kept as that of the body origin. Comes after an
  /// attitude.
  void AddAltitude(double t, double dvl_altitude);
  void AddDepth(double t, double depth);
  /// Fix in W [m] with its 1-sigma.
  void AddGps(double t, const Eigen::Vector2d& p_W, double sd);
  void AddFrame(const FrameDetections& frame);
  void SetFormerSession(FormerSession former);
  void Advance(double now);
  /// Works off what is left and iterates to the optimum.
  SolveReport Finish();

  /// Of the newest attitude; long ago without any.
  [[nodiscard]] double attitude_time() const {
    return track_.is_empty() ? -1e18 : track_.last_time();
  }
  /// True once the chain has its first pose.
  [[nodiscard]] bool has_started() const { return !node_times_.empty(); }
  /// REQUIRES: has_started(), and t no older than the chain's head.
  [[nodiscard]] NavigatorEstimate Estimate(double t) const;
  /// Bottom track alone from the first fix. REQUIRES: has_started().
  [[nodiscard]] Pose DeadReckoned(double t) const;
  /// Frames posed since the last call, in order of exposure.
  [[nodiscard]] std::vector<PosedFrame> TakeFrames();
  [[nodiscard]] std::vector<LandmarkEstimate> Landmarks() const;
  /// Joint covariance of their places, three rows each, in the same order [m^2].
  [[nodiscard]] Eigen::MatrixXd LandmarkCovariance() const;
  /// Grows whenever Landmarks() may answer differently.
  [[nodiscard]] int landmark_version() const { return landmark_version_; }
  /// The chain's poses from the `first` on.
  [[nodiscard]] std::vector<SmoothedPose> Smoothed(int first = 0) const;
  [[nodiscard]] const ObjectTracker& tracker() const { return tracker_; }
  [[nodiscard]] const ChainGraph& graph() const { return smoother_.graph(); }
  [[nodiscard]] const Smoother& smoother() const { return smoother_; }
  /// Of the dead reckoning, now: scale, misalignment [rad], bias of the yaw rate [rad/s].
  [[nodiscard]] Eigen::Vector3d SlowErrorsNow() const { return smoother_.LandmarkAt(errors_); }
  /// Of the former session's frame in this one; as it was before any match.
  [[nodiscard]] const FrameOffset& former_offset() const { return former_.offset(); }
  [[nodiscard]] int node_count() const { return static_cast<int>(node_times_.size()); }
  [[nodiscard]] const NavigatorCounts& counts() const { return counts_; }

 private:
  struct Fix {
    double t;
    Eigen::Vector2d p_W;
    double sd;
  };
  struct Sample {
    double t, value;
  };
  struct MatchedLandmark {
    int slot;
    Eigen::Vector3d p;
  };
  /// False for times that are no number or further ahead of the attitude than any sensor can be.
  [[nodiscard]] bool IsPlausible(double t) const;
  [[nodiscard]] double head_time() const { return node_times_.back(); }
  [[nodiscard]] double NextKeyframe() const;
  void Start(double t, const Eigen::Vector2d& p_W);
  void StartIfPossible(double limit);
  void WorkOff(double limit);
  /// Appends a pose at `t`, or takes the head if it is that old.
  int NodeAt(double t);
  /// Block of the slow errors that hold at `t`; a new one from time to time.
  int ErrorsAt(double t);
  /// In a dropout: block of what the bridged velocity is off.
  int BridgeAt(double t, double age);
  void EndBridge();
  [[nodiscard]] Term StepTerm(double t);
  void AddTilt(int node, double t);
  void AddDepthTerm(int node, double since, double t);
  void TakeFix(const Fix& fix);
  void TakeFrame(const FrameDetections& frame);
  void ReviewObjects(double t);
  /// Which present objects the former session knew, and what it says of their places.
  void MatchFormerObjects();
  /// The landmarks, by id.
  [[nodiscard]] std::vector<const TrackedObject*> KnownObjects() const;
  /// Joint, three rows per slot.
  [[nodiscard]] Eigen::MatrixXd JointCovarianceOf(const std::vector<int>& slots) const;
  [[nodiscard]] bool HasChanged(const PresentLandmarks& present) const;
  void AddSilence(double t, double seconds, NavCovariance& covariance) const;
  [[nodiscard]] NavVector Predict(double t) const;
  [[nodiscard]] NavVector After(const OdometryStep& step, double roll, double pitch) const;
  /// From the head to `t`, slow errors taken out.
  [[nodiscard]] OdometryStep StepTo(double t) const;
  [[nodiscard]] std::optional<double> AltitudeAt(double t) const;
  /// Slope of the last second's depths [m/s].
  [[nodiscard]] std::optional<double> SinkRate() const;

  NavigatorParams params_;
  VelocityGate gate_;
  OdometryTrack track_;
  ArrowSmoother smoother_;
  ObjectTracker tracker_;
  std::vector<double> leaps_;  ///< times of attitudes in a row that leapt ahead
  std::deque<Sample> depths_;
  std::deque<Sample> altitudes_;  ///< of the body origin
  std::deque<Fix> fixes_;
  std::vector<FrameDetections> waiting_;
  std::vector<PosedFrame> posed_;
  std::vector<double> node_times_;
  FormerSessionTie former_;
  std::vector<MatchedLandmark> matched_;  ///< as of the last match with the former session
  double last_fix_t_ = -1e18, last_review_t_ = -1e18, first_time_ = -1.0;
  int errors_ = -1;  ///< block of the smoother's border
  double errors_since_ = 0.0;
  int bridge_ = -1;  ///< the same, in a dropout
  double bridge_since_ = 0.0;
  bool needs_review_ = false;
  int refused_fixes_ = 0, refused_depths_ = 0, landmark_version_ = 0;
  Eigen::Vector3d p_WD_ = Eigen::Vector3d::Zero();  ///< of the track's frame at the start, in W
  NavigatorCounts counts_;
};

}  // namespace limpet
