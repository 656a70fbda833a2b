// SPDX-License-Identifier: MIT
// The estimator behind pNav and `limpet nav`: measurements in, poses and landmarks out.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "estimation/association/object_tracker.hpp"
#include "estimation/navigation/box_motion.hpp"
#include "estimation/navigation/former_matching.hpp"
#include "estimation/navigation/measurement_buffer.hpp"
#include "estimation/navigation/named_state.hpp"
#include "estimation/navigation/navigator_estimate.hpp"
#include "estimation/navigation/navigator_params.hpp"
#include "estimation/navigation/pose_chain.hpp"
#include "estimation/navigation/water_model.hpp"
#include "limpet/core/units.hpp"

namespace mrpt::obs {
class CObservation;
}

namespace limpet {

class AidingSources;
class MeasurementSource;

/// A pose of the chain, smoothed.
struct SmoothedPose {
  double t = 0.0;
  Pose X_WB;
};

/// Measurements come in order of arrival, each with its time of measurement [s]; `Advance` then
/// works off what is complete, in order of time: the chain's head stays `frame_wait` behind, and
/// dead reckoning leads from it to the present. Values that are not numbers are refused and
/// counted.
class Navigator {
 public:
  /// Attitudes closer together than this tell nothing more [s]: 20 Hz are enough.
  static constexpr double kAttitudePeriod = 0.049;

  explicit Navigator(const NavigatorParams& params);
  ~Navigator();
  Navigator(const Navigator&) = delete;
  Navigator& operator=(const Navigator&) = delete;

  void AddAttitude(const AttitudeEstimate& attitude) { measurements_.AddAttitude(attitude); }
  /// Takes the specific force of an accelerometer in body axes [m/s^2]: tells a true change of
  /// velocity from a false one.
  void AddSpecificForce(double t, const Eigen::Vector3d& force_B) {
    measurements_.AddSpecificForce(t, force_B);
  }
  /// Velocity of the DVL in body axes [m/s]; nothing without lock.
  void AddVelocity(double t, const std::optional<Eigen::Vector3d>& v_dvl_B) {
    measurements_.AddVelocity(t, v_dvl_B);
  }
  /// Height of the DVL above the seabed; kept as that of the body origin. Comes after an
  /// attitude.
  void AddAltitude(double t, Meters dvl_altitude) { measurements_.AddAltitude(t, dvl_altitude); }
  /// Takes what the thrusters are told, from which the speed through the water follows; without
  /// effect where the drive's `full_thrust_B` is not known.
  void AddCommand(const ThrusterShares& command) { measurements_.AddCommand(command); }
  void AddDepth(double t, Meters depth) { measurements_.AddDepth(t, depth); }
  /// Takes how far a compass is off the attitude's yaw.
  void AddCompass(double t, Radians off) { measurements_.AddCompass(t, off); }
  /// Fix in W [m] with its 1-sigma.
  void AddGps(double t, const Eigen::Vector2d& p_W, double sd) {
    measurements_.AddFix({.t = t, .p_W = p_W, .sd = sd});
  }
  void AddFrame(const Detections& frame) { measurements_.AddFrame(frame); }
  /// A sensor beside these; its number. Before the first measurement.
  int AddSource(std::unique_ptr<MeasurementSource> source);
  /// What the source of that number has seen, at its own time.
  void AddObservation(int source, std::shared_ptr<mrpt::obs::CObservation> seen);
  void SetFormerSession(FormerSession former) { former_.SetFormer(std::move(former)); }
  void Advance(double now);
  /// Works off what is left and iterates to the optimum.
  SolveReport Finish();

  /// Time of the newest attitude [s]; nothing without any.
  [[nodiscard]] std::optional<double> attitude_time() const;
  /// True once the chain has its first pose.
  [[nodiscard]] bool has_started() const { return chain_.has_begun(); }
  /// True once a fix was believed: else places count from the start, and that is anywhere.
  [[nodiscard]] bool has_fix() const { return chain_.has_fix(); }
  /// Sigma of fixes over what they state, with its 1-sigma; nothing before one was believed.
  [[nodiscard]] std::optional<FixErrorBelief::Ratio> fix_error() const {
    return chain_.has_fix() ? std::optional(chain_.fix_error().ratio()) : std::nullopt;
  }
  /// What the depth sensor reads where fixes come, if that is not the surface [m].
  [[nodiscard]] std::optional<double> surface_reading() const {
    return chain_.depth_errors().surface_reading();
  }
  /// Sensors that cannot all be right.
  [[nodiscard]] std::vector<Disagreement> Disagreements() const;
  /// REQUIRES: has_started(), and t no older than the chain's head.
  [[nodiscard]] NavigatorEstimate Estimate(double t) const {
    return EstimateAt(t, chain_, smoother_, measurements_);
  }
  /// Bottom track alone from the first fix. REQUIRES: has_started().
  [[nodiscard]] Pose DeadReckoned(double t) const { return chain_.DeadReckoned(t); }
  /// Current and speed through the water at `t`, as known now; nothing before a first velocity.
  /// REQUIRES: has_started().
  [[nodiscard]] std::optional<WaterState> Water(double t) const;
  /// Current and speed through the water, and what sensors and their mounting are off, as known at
  /// `t`. REQUIRES: has_started().
  [[nodiscard]] std::vector<NamedState> States(double t) const;
  /// What the compass is off; nothing without one, or before the start.
  [[nodiscard]] std::optional<Compass::Deviation> compass_deviation() const {
    return compass_.deviation();
  }
  /// Radii of the landmarks, `radius_<id>` [m]; none if sizes are taken for known.
  [[nodiscard]] std::vector<NamedState> Sizes() const;
  /// Frames posed since the last call, in order of exposure.
  [[nodiscard]] std::vector<ObservedFrame> TakeFrames();
  [[nodiscard]] std::vector<Landmark> Landmarks() const;
  /// Joint covariance of their places, three rows each, in the same order [m^2].
  [[nodiscard]] Eigen::MatrixXd LandmarkCovariance() const;
  /// Grows whenever Landmarks() may answer differently.
  [[nodiscard]] int landmark_version() const { return landmark_version_; }
  /// The chain's poses from the `first` on.
  [[nodiscard]] std::vector<SmoothedPose> Smoothed(int first = 0) const;
  /// 1-sigmas of north, east, down [m] and heading [rad] of all of them.
  [[nodiscard]] std::vector<Eigen::Vector4d> SmoothedSigmas() const;
  [[nodiscard]] const ObjectTracker& tracker() const { return tracker_; }
  [[nodiscard]] const ChainGraph& graph() const { return smoother_.graph(); }
  [[nodiscard]] const Smoother& smoother() const { return smoother_; }
  /// Offset of the former session's frame in this one; as it was before any match.
  [[nodiscard]] FrameOffset former_offset() const { return former_.offset(); }
  /// That frame lies where neither session's fixes and compass would have it.
  [[nodiscard]] bool is_former_elsewhere() const { return former_.is_elsewhere(); }
  [[nodiscard]] int node_count() const { return chain_.size(); }
  [[nodiscard]] const AidingSources& aiding() const { return *aiding_; }
  [[nodiscard]] const NavigatorCounts& counts() const { return measurements_.counts(); }

 private:
  void StartIfPossible(double limit);
  void Begin(double t, const Eigen::Vector2d& p_W);
  /// Fixes, frames and keyframes up to `limit`, in order of time.
  void WorkOff(double limit);
  void UseCompass(double t, int node);
  int NodeAt(double t);
  void TakeFix(const PositionFix& fix);
  void TakeObservation(double t);
  void TakeFrame(const Detections& frame);
  [[nodiscard]] BodyMotion MotionAt(double t) const;
  void ReviewObjects(double t);
  void ConvergeAndRefresh(SolveReport& report);
  /// The landmarks, by id.
  [[nodiscard]] std::vector<const TrackedObject*> LandmarksById() const;

  NavigatorParams params_;
  MeasurementBuffer measurements_;
  ArrowSmoother smoother_;
  ObjectTracker tracker_;
  PoseChain chain_;
  Compass compass_;
  BoxMotion box_motion_;
  FormerMatching former_;
  std::unique_ptr<AidingSources> aiding_;
  std::vector<ObservedFrame> posed_;
  std::optional<double> first_time_;     ///< of an attitude, while no fix has come
  std::optional<double> last_review_t_;  ///< of the objects
  bool needs_review_ = false;
  int landmark_version_ = 0;
};

}  // namespace limpet
