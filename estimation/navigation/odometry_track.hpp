// SPDX-License-Identifier: MIT
// Dead reckoning between nodes: attitude and bottom-track velocity compounded into one
// displacement.
#pragma once

#include <algorithm>
#include <deque>
#include <optional>

#include <Eigen/Core>

#include "estimation/attitude/attitude_filter.hpp"
#include "estimation/navigation/bridge_end.hpp"
#include "estimation/navigation/driven_speed.hpp"
#include "estimation/navigation/dvl_velocities.hpp"
#include "estimation/navigation/untold_stop.hpp"
#include "estimation/navigation/water_model.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/interval.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

struct OdometryParams {
  Eigen::Vector3d dvl_B = {-0.2, 0.0, 0.18};  ///< lever arm of the DVL in the body frame [m]
  double velocity_noise = 0.012;              ///< of one horizontal velocity sample [m/s]
  Seconds velocity_period{0.2};               ///< until the DVL's own is known
  double scale_sigma = 0.0028;                ///< of the velocity's scale, a bias along included
  double misalign_sigma = 0.0033;             ///< of its misalignment [rad], a bias across included
  double gyro_scale_sigma = 0.0;     ///< of the yaw rate's scale; with the next: 0, not estimated
  double dvl_lever_sigma = 0.0;      ///< of where the DVL is, ahead and to starboard [m]
  double changing_share = 0.3;       ///< of the slow errors that does not stay the same for long
  Meters scale_correlation{30.0};    ///< way after which that share of scale is taken as new
  WaterParams water;                 ///< bridges a dropout
  DriveParams drive;                 ///< and what the thrusters do in it
  Seconds bridge_correlation{10.0};  ///< the error stays the same for about this long
  /// Without any velocity for longer than `bridge_trusted`, or
  /// without attitude, nothing is known of the motion but what the vehicle and the water can do:
  /// a velocity that stays the same, with this 1-sigma [m/s], horizontal (each way) and vertical.
  Seconds bridge_trusted{240.0};
  double unknown_velocity = 0.75;
  double unknown_sink = 0.3;
  double yaw_walk = 3.5e-6;  ///< [rad/sqrt(s)]
  double yaw_bias = 9.7e-6;  ///< [rad/s], new every `yaw_bias_correlation`
  Seconds yaw_bias_correlation{600.0};
};

/// Motion from one time to another in the levelled heading frame of the first: x forward, y right,
/// z down [m], change of yaw [rad]; variances of each; way travelled [m].
struct OdometryStep {
  Eigen::Vector4d motion = Eigen::Vector4d::Zero();
  Eigen::Vector4d variance = Eigen::Vector4d::Zero();
  double duration = 0.0;
  double path = 0.0;
  double bridge_variance = 0.0;  ///< what dropouts put into the horizontal variances [m^2]
};

/// What silence of `seconds`, of all that tells how the vehicle moves, adds to variances.
struct SilenceVariance {
  double horizontal = 0.0, vertical = 0.0;  ///< [m^2]
  double yaw = 0.0;                         ///< [rad^2]
};
[[nodiscard]] SilenceVariance VarianceOfSilence(const OdometryParams& params, double seconds);

/// Body pose in the track's own drifting frame, oriented by the attitude filter's yaw.
struct TrackPose {
  double t = 0.0;
  Pose X_DB;
  Eigen::Vector3d v_B = Eigen::Vector3d::Zero();  ///< of the body origin [m/s]
  double yaw_rate = 0.0;
  /// Covariance of the place in a dropout, because the vehicle may have stopped meanwhile [m^2].
  Eigen::Matrix2d stop_covariance_D = Eigen::Matrix2d::Zero();
};

/// Compounds attitude and velocity samples, each in time order, and answers for any time of the
/// last seconds. A missing velocity is bridged by what the vehicle did in the water and the water
/// itself. The vertical part is then the sink rate, if known.
class OdometryTrack {
 public:
  explicit OdometryTrack(const OdometryParams& params)
      : params_(params),
        velocities_(params.velocity_period),
        water_(params.water, params.dvl_B.x()),
        driven_(params.drive),
        bridge_end_(params.velocity_noise) {}

  void AddAttitude(const AttitudeEstimate& attitude);
  /// Velocity of the DVL in body axes [m/s] at `t`; nothing when the DVL had no lock or lied.
  void AddVelocity(double t, const std::optional<Eigen::Vector3d>& v_dvl_B);

  /// A velocity at `t` that AddVelocity was not given, since it may be false: what the vehicle
  /// would have gone besides, if it is not, is kept until it is known to be false or believed after
  /// all. Then the track catches up, and says how far it was off.
  void NoteContested(double t, const Eigen::Vector3d& v_dvl_B);
  void ForgetContested();
  void BelieveContested();

  /// A fix at `t` [s] has shown where the vehicle is: silence begins anew.
  void NoteFix(double t) {
    fix_t_ = std::max(fix_t_.value_or(t), t);
    if (!is_empty()) samples_.back().stop = {};
  }

  /// The vehicle is at the surface at `t` [s]: what it does there is no habit of its dive.
  void NoteSurface(double t) { water_.NoteSurface(t); }

  /// Rate of depth [m/s] that stands in for the vertical velocity in a dropout.
  void SetSinkRate(double rate) { sink_rate_ = rate; }

  [[nodiscard]] const OdometryParams& params() const { return params_; }
  [[nodiscard]] bool is_empty() const { return samples_.empty(); }
  [[nodiscard]] double first_time() const { return samples_.front().attitude.t; }
  [[nodiscard]] double last_time() const { return samples_.back().attitude.t; }
  /// Up to here later velocities change nothing any more; nothing before the first one.
  [[nodiscard]] std::optional<double> settled_time() const {
    return velocities_.empty() ? std::nullopt : std::optional(velocities_.newest_time());
  }
  /// Age of the present dropout, as DvlVelocities::DropoutAge has it.
  [[nodiscard]] std::optional<double> DropoutAge(double t) const {
    return velocities_.DropoutAge(t);
  }

  /// Velocity of the DVL in body axes [m/s] that a dropout at `t` is bridged with; nothing while
  /// there is none.
  [[nodiscard]] std::optional<Eigen::Vector3d> BridgedAt(double t) const;

  /// The end of the last dropout that has ended; nothing before one.
  [[nodiscard]] const std::optional<BridgeEnd>& bridge_end() const { return bridge_end_.end(); }

  /// What the thrusters are told from its time on.
  void AddCommand(const ThrusterShares& command) {
    driven_.AddCommand(command, is_empty() ? 0.0 : samples_.back().turn_rate);
  }

  /// Current and speed through the water; its north is the attitude's.
  [[nodiscard]] const WaterModel& water() const { return water_; }
  /// REQUIRES: !is_empty().
  [[nodiscard]] Conduct ConductAt(double t) const;

  /// REQUIRES: !is_empty(). Times outside the buffer answer with its ends, extrapolated by at most
  /// 0.3 s at the new end.
  [[nodiscard]] TrackPose At(double t) const;
  [[nodiscard]] AttitudeEstimate AttitudeAt(double t) const;
  /// Way travelled since the first sample [m].
  [[nodiscard]] double PathAt(double t) const;
  /// The motion over a span of times [s]. REQUIRES: neither buffer nor span is empty.
  [[nodiscard]] OdometryStep Between(const Interval& span) const;
  /// Forgets what is older than `t`.
  void DropBefore(double t);

 private:
  struct Sample {
    AttitudeEstimate attitude;  ///< yaw unwrapped
    Eigen::Matrix3d R_DB = Eigen::Matrix3d::Identity();
    Eigen::Vector3d p_dvl = Eigen::Vector3d::Zero();  ///< of the DVL in the track's frame
    double path = 0.0;
    double bridge_variance = 0.0;  ///< horizontal, accumulated over dropouts [m^2]
    /// Squared seconds, `t^2` after t, accumulated [s^2]: in which nothing told where it goes, and
    /// of them those without attitude.
    double unknown_way = 0.0, unattended = 0.0;
    double turn_rate = 0.0;  ///< of yaw, smoothed [rad/s]
    UntoldStop stop{};       ///< of this dropout
    /// Shift of the track, to catch up with what was not believed at first, in its frame [m].
    Eigen::Vector2d shift = Eigen::Vector2d::Zero();
  };
  /// Neighbouring samples about a time, and the share of the way from one to the other.
  struct Bracket {
    const Sample* before = nullptr;
    const Sample* after = nullptr;
    double share = 0.0;
  };
  /// Nothing outside the buffer.
  [[nodiscard]] std::optional<Bracket> Around(double t) const;
  [[nodiscard]] static AttitudeEstimate Between(const Bracket& around, double t);
  [[nodiscard]] Conduct ConductOf(const Sample& sample) const;
  /// Holds a velocity against the bridge, before the water model learns from it.
  void HoldAgainstBridge(double t, const Eigen::Vector3d& v_dvl_B);
  void TeachWater(double t, const Eigen::Vector3d& v_dvl_B);
  /// Velocity in a dropout, in the track's frame [m/s].
  [[nodiscard]] Eigen::Vector3d BridgedVelocity(double t, const Conduct& conduct) const;
  /// The velocity in the track's frame, measured or bridged.
  [[nodiscard]] Eigen::Vector3d LevelVelocity(const Sample& sample) const;
  [[nodiscard]] Sample SampleAt(double t) const;
  void Integrate(const Sample& from, Sample& to) const;
  /// Seconds that nothing has told of the motion at `t`, beyond what a bridge is trusted for.
  [[nodiscard]] double UntrustedSilence(double t) const;

  OdometryParams params_;
  std::deque<Sample> samples_;
  DvlVelocities velocities_;
  std::optional<double> fix_t_;                              ///< of the last fix
  double began_t_ = 0.0;                                     ///< of the first attitude
  Eigen::Vector2d contested_way_ = Eigen::Vector2d::Zero();  ///< in the track's frame [m]
  WaterModel water_;
  DrivenSpeed driven_;
  BridgeEndCheck bridge_end_;
  std::optional<double> sink_rate_;
};

}  // namespace limpet
