// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

#include <Eigen/Core>

#include "limpet/core/units.hpp"

namespace limpet {

/// What thrusters, hull and coastal water usually do, each with a margin; random walks in units per
/// root second.
struct WaterParams {
  /// 1-sigma of a bottom-track velocity about this model [m/s]: the sensor's noise (0.01) and what
  /// hull and waves do besides.
  double velocity_noise = 0.02;
  /// Of the speed ahead through the water, at first, and of a vehicle that stands and may go [m/s]:
  /// what it may have been told, half its top speed.
  double speed_sigma = 0.5;
  double speed_walk = 0.0005;   ///< random walk of that speed [m/s/sqrt(s)]
  double drift_sigma = 0.008;   ///< of the speed abeam through the water [m/s]
  Seconds drift_memory{600.0};  ///< after which that is another
  double sway_sigma = 0.3;      ///< of the sway per yaw rate, at first [m/s per rad/s]
  double sway_walk = 0.002;     ///< random walk of that sway
  /// With commands of the thrusters: 1-sigma of what is left of speed ahead and abeam beside what
  /// they make [m/s], after which that is another, of how much of that is true, its random walk,
  /// and the share of its changes that is not.
  double beside_driven = 0.03;
  Seconds beside_memory{60.0};
  double driven_sigma = 0.3, driven_walk = 0.0005;
  double driven_change = 0.2;
  double current_sigma = 0.15;   ///< of each of north and east, at first [m/s]
  double current_walk = 0.0007;  ///< random walk of the current [m/s/sqrt(s)]
  /// 1-sigma of a predicted velocity besides [m/s]: at first and at least. Learnt from what the
  /// model would have been off in stretches so long, each taken as no worse than the worst; so a
  /// vehicle that is less steady than the model is bridged with more doubt.
  double model_error = 0.005;
  Seconds trial{20.0};
  double worst_trial = 0.06;
  Seconds trial_memory{600.0};
  /// Who was told another speed lately may be told one now: 1-sigma of the speed ahead, as a share
  /// of its spread about the usual one, reached at this rate [m/s^2].
  double maneuver_share = 0.6;
  double maneuver_mps2 = 0.05;
  /// Who stands at the surface, or below half the speed it had before, is about to go: nobody knows
  /// when, nor how fast. So is one that came from there so lately, or of which no velocity was
  /// measured yet. It then does the same for about this long.
  Seconds departure{60.0}, conduct_memory{30.0};
  Seconds usual_memory{60.0};     ///< over which the usual speed through the water is averaged
  double usual_band = 0.1;        ///< a speed further from the usual one is not held for long [m/s]
  Seconds excursion_memory{4.0};  ///< in which it comes back that near
};

/// What the vehicle did when it had a velocity: heading [rad], yaw rate [rad/s], and speed ahead
/// and abeam through the water that its thrusters alone would make [m/s], if their commands are
/// known.
struct Conduct {
  double yaw = 0.0, rate = 0.0;
  std::optional<Eigen::Vector2d> driven_B{};
};

/// How what a bridge is off goes on: 1-sigma of what comes to current north and east, and to speed
/// ahead [m/s], and which share of the latter is left.
struct BridgeDrift {
  double current_change = 0.0, speed_change = 0.0;
  double speed_kept = 1.0;
};

/// Current (north, east) and speed ahead through the water, as estimated [m/s], with 1-sigma.
struct WaterState {
  Eigen::Vector2d current_W = Eigen::Vector2d::Zero(), sd_current_W = Eigen::Vector2d::Zero();
  double speed = 0.0, sd_speed = 0.0;
};

/// Parts the velocity over ground into what the vehicle does in the water and what the water does:
/// a Kalman filter of (speed ahead, speed abeam, sway per yaw rate, current north, current east,
/// how much of the speed that the thrusters make is true). All but the current turn with the
/// vehicle; so a turn tells them apart, and before one the covariance says that nothing has.
/// Without commands of the thrusters the speed through the water is a random walk; a change that
/// this does not explain is taken for a change of speed, not of the current. With them the first
/// two are what is left beside what the thrusters make, and little. The DVL's lever arm is part of
/// the sway. Times in seconds.
class WaterModel {
 public:
  using State = Eigen::Matrix<double, 6, 1>;
  using Covariance = Eigen::Matrix<double, 6, 6>;

  /// `arm`: how far ahead of the body's origin the DVL is [m]; the sway until turns teach it.
  WaterModel(const WaterParams& params, double arm);

  /// Velocity of the DVL over ground [m/s], ahead and abeam in the levelled heading frame.
  void Add(double t, const Eigen::Vector2d& v_H, const Conduct& conduct);

  /// The vehicle is at the surface at `t`, says a fix: what it does there is no habit.
  void NoteSurface(double t) { departed_ = std::max(departed_.value_or(t), t); }

  /// Velocity of the DVL over ground [m/s] at `t`, north and east, for when nothing measures it.
  [[nodiscard]] Eigen::Vector2d VelocityAt(double t, const Conduct& conduct) const;
  /// Variance of each axis of VelocityAt, their mean [m^2/s^2].
  [[nodiscard]] double VarianceAt(double t, const Conduct& conduct) const;
  /// Covariance of (current north, current east, speed ahead) at `t`, with what the model leaves
  /// out [m^2/s^2]: what a bridge from there is off.
  [[nodiscard]] Eigen::Matrix3d BridgeCovariance(double t, const Conduct& conduct) const;
  /// How these change from `from` to `to`, `seconds` later.
  [[nodiscard]] BridgeDrift BridgeChange(double seconds, const Conduct& from,
                                         const Conduct& to) const;
  /// So long they may be taken for constant, if the vehicle goes on as told now [s].
  [[nodiscard]] double BridgeStretch(const Conduct& from, const Conduct& to) const;
  /// 1-sigma of where they carry the vehicle besides in a second of such a stretch [m].
  [[nodiscard]] double BridgeNoise(const Conduct& conduct) const;

  /// Variance of each of ahead and abeam of what the error of a bridge of `seconds` is at its end,
  /// beside what it was all along [m^2/s^2]: a vehicle that is told another speed by then tells
  /// little of the bridge.
  [[nodiscard]] Eigen::Vector2d EndVariance(double seconds, const Conduct& conduct) const;

  /// Speed ahead through the water at `t` of a vehicle that is taken to go on as it did [m/s]; 0 if
  /// its commands are known, or a start is expected of it anyway.
  [[nodiscard]] double HabitualSpeed(double t) const {
    return driven_B_ || !t_ || UntoldSpeed() > 0.0 ? 0.0 : SpeedAt(t);
  }

  /// How often it stops while it is under way, as seen so far [1/s].
  [[nodiscard]] double StopRate() const {
    return (kStopsBefore + stops_) / (kUnderWayBefore + under_way_);
  }

  [[nodiscard]] WaterState StateAt(double t, const Conduct& conduct) const;
  /// False until a first velocity has come.
  [[nodiscard]] bool has_velocity() const { return t_.has_value(); }
  [[nodiscard]] const State& state() const { return x_; }

 private:
  /// A prediction that goes on beside the filter, to see how good a bridge would be now.
  struct Trial {
    double since = 0.0, last = 0.0;  ///< [s]
    State x;
    Eigen::Vector2d off = Eigen::Vector2d::Zero();  ///< sum of what it is off, north and east [m/s]
    int count = 0;
  };
  using Observation = Eigen::Matrix<double, 2, 6>;
  /// Begins anew with what is known before a first velocity.
  void Begin(bool is_driven);
  /// Velocity ahead and abeam of a state.
  [[nodiscard]] static Observation ObservationOf(const Conduct& conduct);
  /// Tries what a bridge would be off. `v_H` as in Add.
  void Try(double t, const Eigen::Vector2d& v_H, const Observation& H);
  /// What is known before a first velocity.
  [[nodiscard]] Covariance FirstCovariance(bool is_driven) const;
  [[nodiscard]] Covariance CovarianceAt(double t) const;
  /// What is known at `t` if commands are all that was ever heard.
  [[nodiscard]] Covariance CovarianceAt(double t, const Conduct& conduct) const;
  /// 1-sigma of the speed ahead of a vehicle that may start any time [m/s]; 0 of one that is on
  /// its way, or whose commands are known.
  [[nodiscard]] double UntoldSpeed() const;
  /// Share of its variance that is new after `seconds`.
  [[nodiscard]] double LostIn(double seconds) const;
  void LearnHabit(double t);
  void CountStops(double seconds);
  [[nodiscard]] double AgeAt(double t) const;
  /// Share of a change of what the thrusters make that may be untrue, squared.
  [[nodiscard]] double UntrueShare() const;
  /// Variance of speed ahead and abeam, since the last velocity: what the thrusters' sheet may be
  /// off.
  [[nodiscard]] Eigen::Vector2d DrivenVariance(const Conduct& conduct) const;
  /// Variance of the speed ahead: what it may have been told to change.
  [[nodiscard]] double ManeuverVariance(double seconds) const;
  /// Share of speed abeam, and of speed ahead beside the thrusters', that is left at `t`.
  [[nodiscard]] double KeepAt(double t) const;
  /// Speed ahead at `t`, what the thrusters make left out: as it was, or back near the usual one.
  [[nodiscard]] double SpeedAt(double t) const;

  WaterParams params_;
  double arm_;  ///< of the DVL [m]
  /// What the thrusters made at the last velocity; nothing without their commands.
  std::optional<Eigen::Vector2d> driven_B_;
  State x_;
  Covariance P_;
  std::optional<double> t_;             ///< of the last velocity
  std::optional<double> departed_;      ///< last at the surface, or without any velocity [s]
  double usual_ = 0.0, fastest_ = 0.0;  ///< speed ahead, and the most of that under water
  double spread_ = 0.0;                 ///< variance about it [m^2/s^2]
  /// Of a vehicle of which nothing is known: half a stop in an hour [s].
  static constexpr double kStopsBefore = 0.5, kUnderWayBefore = 3600.0;
  bool is_going_ = false;
  double stops_ = 0.0, under_way_ = 0.0;  ///< under water; for how long it was not standing [s]
  std::optional<Trial> trial_;
  double error_variance_;  ///< of a predicted velocity, besides [m^2/s^2]
};

}  // namespace limpet
