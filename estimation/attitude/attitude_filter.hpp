// SPDX-License-Identifier: MIT
// Roll, pitch and yaw from inertial sensors and a fibre-optic gyro.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "estimation/attitude/inertial_gate.hpp"
#include "estimation/attitude/inertial_input.hpp"
#include "limpet/core/long_ago.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// What the attitude filter believes at `t` [s]; angles [rad] of R_WB = Rz(yaw) Ry(pitch) Rx(roll).
struct AttitudeEstimate {
  double t = 0.0;
  double roll = 0.0, pitch = 0.0, yaw = 0.0;
  double yaw_rate = 0.0;  ///< [rad/s]
  double sd_roll = 0.0, sd_pitch = 0.0, sd_yaw = 0.0;
};

struct AttitudeParams {
  Radians gyro_noise{0.002};        ///< of p, q over one second [rad/sqrt(s)]
  Radians gyro_bias_walk{2e-5};     ///< random walk of their biases over one second
  Radians gyro_bias_sigma{0.005};   ///< at the start [rad/s, as an angle per second]
  Radians tilt_sigma{0.03};         ///< of one tilt from specific force, waves included
  double force_gate = 0.4;          ///< | |f| - g | beyond which gravity is not trusted [m/s^2]
  Radians tilt_floor{0.0047};       ///< slow errors that averaging does not remove
  Radians heading_sigma{0.00873};   ///< of the magnetic heading, constant over a session
  Seconds alignment{5.0};           ///< magnetic heading is averaged this long at the start
  Radians yaw_random_walk{3.5e-6};  ///< of the fibre-optic gyro over one second [rad/sqrt(s)]
  Radians yaw_bias_sigma{9.7e-6};   ///< its bias over one second [rad/s]
};

/// Extended Kalman filter over roll, pitch and the biases of p and q; specific force, less the
/// centripetal part that the known body velocity explains, gives the tilt while it looks like
/// gravity. Yaw is the integral of the fibre-optic gyro, turned into a yaw rate through roll and
/// pitch, from the magnetic heading averaged over the alignment time: absolute error constant,
/// increments good. After a gap in the samples nobody knows how far the vehicle has turned: the
/// heading is aligned anew, to a compass whose error is the same as at the start.
class AttitudeFilter {
 public:
  explicit AttitudeFilter(const AttitudeParams& params) : params_(params) {}

  /// Body z rate of the fibre-optic gyro at `t` [s]; used for samples of the IMU up to 0.2 s off.
  void AddFogRate(double t, RadiansPerSecond rate);
  /// Advances the filter; false for a sample that is refused: not newer than the last one, not
  /// finite, leaping far ahead, which takes a few in a row to be believed, or an outlier. Nothing
  /// is ever integrated backwards. A clock that was set back has hidden how far the vehicle turned
  /// meanwhile: that is a gap.
  bool AddInertial(const InertialInput& input);
  /// Body velocity over ground [m/s], for the centripetal part of the specific force.
  void SetBodyVelocity(const Eigen::Vector3d& v_WB_B) { v_WB_B_ = v_WB_B; }

  [[nodiscard]] bool is_aligned() const;
  [[nodiscard]] const std::optional<AttitudeEstimate>& estimate() const { return estimate_; }
  /// Samples since the start that were out of order or not finite.
  [[nodiscard]] int refused() const { return refused_; }
  /// Samples since the start that were outliers.
  [[nodiscard]] int outliers() const { return outliers_; }
  /// The last sample's heading may be used: it is no outlier, which its rates and forces need not
  /// share.
  [[nodiscard]] bool has_heading() const { return has_heading_; }
  [[nodiscard]] Eigen::Vector2d gyro_bias() const { return x_.tail<2>(); }

 private:
  [[nodiscard]] bool IsInOrder(const InertialInput& input);
  /// Verdict on a sample that is in order: whether it is an outlier, and whether its heading is.
  [[nodiscard]] InertialGate::Verdict Judge(const InertialInput& input);
  void Start(const InertialInput& input);
  void Predict(const Eigen::Vector3d& rate_B, double dt);
  void CorrectTilt(const InertialInput& input, double yaw_body_rate);
  /// `gap`: since the sample before.
  void AlignHeading(const InertialInput& input, double gap);

  AttitudeParams params_;
  InertialGate gate_;
  Eigen::Vector4d x_ = Eigen::Vector4d::Zero();  ///< roll, pitch, bias of p, bias of q
  Eigen::Matrix4d P_ = Eigen::Matrix4d::Identity();
  Eigen::Vector3d v_WB_B_ = Eigen::Vector3d::Zero();
  double fog_t_ = kLongAgo, fog_rate_ = 0.0;
  double start_t_ = 0.0, aligned_from_ = 0.0;
  double last_t_ = kLongAgo;                    ///< of the last sample in order
  double yaw_integral_ = 0.0, yaw_rate_ = 0.0;  ///< since the start
  double heading_offset_ = 0.0;                 ///< yaw less its integral, averaged
  double heading_weight_ = 0.0;                 ///< of the average so far
  std::optional<AttitudeEstimate> estimate_;
  int refused_ = 0, outliers_ = 0;
  bool has_heading_ = false;
  int set_back_ = 0;       ///< older than the last good one, in a row
  int leaps_ = 0;          ///< far ahead of it, in a row
  double leapt_to_ = 0.0;  ///< time of the last of those
};

}  // namespace limpet
