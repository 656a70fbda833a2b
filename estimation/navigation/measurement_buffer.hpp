// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "estimation/attitude/attitude_filter.hpp"
#include "estimation/navigation/inertial_velocity.hpp"
#include "estimation/navigation/odometry_track.hpp"
#include "estimation/navigation/position_fix.hpp"
#include "estimation/navigation/scalar_history.hpp"
#include "estimation/navigation/sensor_agreement.hpp"
#include "estimation/navigation/time_gate.hpp"
#include "estimation/navigation/velocity_gate.hpp"
#include "limpet/core/long_ago.hpp"
#include "limpet/core/units.hpp"
#include "limpet/objects/frame.hpp"

namespace limpet {

/// Measurements that were refused, since the start.
struct NavigatorCounts {
  int velocities = 0, depths = 0, fixes = 0, late_frames = 0, stale_samples = 0, looks = 0;
};

/// Takes measurements in order of arrival, refuses and counts what cannot be, and keeps what is to
/// be worked off and what the last seconds brought. Times in seconds.
class MeasurementBuffer {
 public:
  /// `depth_sigma`: of the depths of a second [m].
  MeasurementBuffer(const OdometryParams& odometry, const VelocityGateParams& velocity_gate,
                    Meters depth_sigma);

  void AddAttitude(const AttitudeEstimate& attitude);
  /// Takes the specific force of an accelerometer in body axes [m/s^2]. Comes after an attitude.
  void AddSpecificForce(double t, const Eigen::Vector3d& force_B);
  /// Takes a velocity of the DVL in body axes [m/s]; nothing without lock.
  void AddVelocity(double t, const std::optional<Eigen::Vector3d>& v_dvl_B);
  /// Takes the height of the DVL above the seabed; kept as that of the body origin. Comes after
  /// an attitude.
  void AddAltitude(double t, Meters dvl_altitude);
  /// Takes the range of an echo sounder in body axes. It counts while the DVL gives no altitude.
  /// Comes after an attitude.
  void AddSounding(double t, const Eigen::Vector3d& p_BS, double range);
  void AddDepth(double t, Meters depth);
  /// Takes how far a compass is off the attitude's yaw.
  void AddCompass(double t, Radians off);
  void AddCommand(const ThrusterShares& command) {
    if (IsPlausible(command.t)) track_.AddCommand(command);
  }
  void AddFix(const PositionFix& fix);
  void AddFrame(const Detections& frame);
  /// Forgets samples older than `t`, but for what is still to be worked off.
  void DropBefore(double t);

  [[nodiscard]] const OdometryTrack& track() const { return track_; }
  [[nodiscard]] OdometryTrack& track() { return track_; }
  [[nodiscard]] const ScalarHistory& depths() const { return depths_; }
  /// The compass's heading at `t` [rad], if measured about then.
  [[nodiscard]] std::optional<double> CompassAt(double t) const;
  /// Height of the body origin above the seabed, if measured about then [m].
  [[nodiscard]] std::optional<double> AltitudeAt(double t) const;
  [[nodiscard]] std::deque<PositionFix>& fixes() { return fixes_; }
  [[nodiscard]] std::vector<Detections>& frames() { return frames_; }
  [[nodiscard]] const SensorAgreement& agreement() const { return agreement_; }
  [[nodiscard]] const NavigatorCounts& counts() const { return counts_; }
  [[nodiscard]] NavigatorCounts& counts() { return counts_; }

 private:
  /// False for times that are no number or further ahead of the attitude than any sensor can be.
  [[nodiscard]] bool IsPlausible(double t) const;
  /// Rotation from the body to level axes, by the attitude. REQUIRES: there is one.
  [[nodiscard]] Eigen::Matrix3d LevelRotationAt(double t) const;
  /// Velocity of the DVL because the body turns about its origin [m/s]. REQUIRES: an attitude.
  [[nodiscard]] Eigen::Vector3d SwingAt(double t) const;
  /// What is known of the velocity of the body's origin at `t`.
  [[nodiscard]] VelocityEvidence EvidenceAt(double t) const;
  /// Verdict on what the DVL measured, as the velocity of the body's origin.
  [[nodiscard]] VelocityGate::Verdict Judge(double t, const Eigen::Vector3d& v_dvl_B);

  /// What a velocity says of the same motion as depth and thrusters.
  void CompareVelocity(double t, const Eigen::Vector3d& v_dvl_B);

  Eigen::Vector3d p_dvl_B_;
  VelocityGate velocity_gate_;
  InertialVelocity felt_;
  TimeGate attitude_gate_;
  OdometryTrack track_;
  ScalarHistory depths_, altitudes_;  ///< altitudes: of the body origin
  double dvl_altitude_t_ = kLongAgo;  ///< of the last one that the DVL gave
  ScalarHistory compass_;             ///< off the attitude's yaw
  SensorAgreement agreement_;
  std::deque<PositionFix> fixes_;
  std::vector<Detections> frames_;
  NavigatorCounts counts_;
};

}  // namespace limpet
