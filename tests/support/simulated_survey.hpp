// SPDX-License-Identifier: MIT
// Place, water and vehicle of a simulated session, before any sensor.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limpet/core/frames.hpp"
#include "limpet/core/interval.hpp"
#include "limpet/core/random.hpp"
#include "limpet/simulation/object_motion.hpp"
#include "limpet/simulation/simulated_errors.hpp"
#include "limpet/simulation/tidal_current.hpp"

namespace limpet {

/// What is simulated. Defaults: ten minutes over four objects, as in the paper's Table 1.
struct StreamScene {
  std::uint64_t seed = 1;
  double duration_s = 600.0;
  double half_size_m = 16.0;  ///< of the square that is surveyed
  double leg_spacing_m = 4.0;
  int objects = 4;
  int classes = 1;
  bool has_twins = false;    ///< every second object stands 1.1 m beside the one before
  int look_alikes = 0;       ///< things on the seabed that now and then are taken for objects
  bool is_rough = false;     ///< slope and bumps instead of a flat seabed
  double tilt_deg = 30.0;    ///< of the camera, forward from nadir
  double altitude_m = 4.0;   ///< that is flown at
  double false_share = 0.1;  ///< of all boxes
  double yaw_bias_degph = 2.0;
  int long_dropouts = 0;  ///< of the DVL
  double shortest_dropout_s = 25.0, longest_dropout_s = 60.0;
  bool has_turns_in_dropouts = false;  ///< each begins shortly before a turn of the survey
  /// Strongest current: a session's own is anything up to it, from anywhere, and changes slowly.
  double current_mps = 0.0;
  double leg_speed_sd_mps = 0.02;  ///< of the speed through the water, from leg to leg
  int velocity_bursts = 0;  ///< of 2 to 4 s in which the DVL says one wrong velocity, as valid
  double dvl_period_s = 0.2;
  double noise = 1.0;  ///< of DVL, depth and tilt, over the usual; the rows state it
  double resurface_every_s = 0.0;
  double true_fix_error = 1.0;  ///< of what wanders of fixes, over the usual 0.5 m; none is told
  std::optional<Interval> standing{};  ///< times [s] in which the vehicle does not go ahead
  std::uint64_t place = 0;             ///< seed of the seabed and what stands on it; 0: `seed`
  int gone = 0, came = 0;    ///< of the place's objects, the first are gone, and others came since
  double size_spread = 1.0;  ///< objects are up to this factor larger or smaller than believed
  double true_noise = 1.0;   ///< of DVL, depth, tilt and boxes, over what is stated
  ObjectMotionParams motion{};  ///< of every object
  SimulatedErrors errors{};     ///< what differs from what the estimator is told
  /// Instead of the slow swing that a session's current has otherwise.
  std::optional<TidalCurrentParams> tide{};
};

constexpr double kSimulationStep = 0.05;  // [s]

/// Noise that stays the same for about `tau`: first-order Gauss-Markov.
class SlowNoise {
 public:
  SlowNoise(Random& random, double sigma, double tau)
      : random_(random), sigma_(sigma), tau_(tau), value_(random.Normal(sigma)) {}
  double Step(double dt);

 private:
  Random& random_;
  double sigma_, tau_, value_;
};

/// The seabed's depth and what stands on it.
class SimulatedGround {
 public:
  explicit SimulatedGround(const StreamScene& scene);
  [[nodiscard]] double Depth(const Eigen::Vector2d& p) const;
  [[nodiscard]] const std::vector<Eigen::Vector3d>& objects() const { return objects_; }
  [[nodiscard]] const std::vector<Eigen::Vector3d>& look_alikes() const { return look_alikes_; }
  /// Of an object's radius over the believed one.
  [[nodiscard]] double size(std::size_t object) const { return sizes_[object]; }

 private:
  void Place(std::vector<Eigen::Vector3d>& things, double apart);
  const StreamScene& scene_;
  Random random_;
  Eigen::Vector2d slope_;
  std::array<double, 3> phases_{};
  std::vector<Eigen::Vector3d> objects_, look_alikes_;
  std::vector<double> sizes_;
};

/// The water's own motion: a session's mean, from anywhere, that a tide swings, and a little
/// unrest.
[[nodiscard]] TidalCurrent CurrentOf(const StreamScene& scene);

/// Where the vehicle really is: it follows the survey's legs, along and across in turn.
class SimulatedVehicle {
 public:
  SimulatedVehicle(const StreamScene& scene, const SimulatedGround& ground);
  void Step(double t);
  [[nodiscard]] const Pose& pose() const { return X_; }
  [[nodiscard]] double yaw_rate() const { return rate_; }
  /// In body axes.
  [[nodiscard]] BodyMotion motion() const;
  [[nodiscard]] bool is_up() const { return is_up_; }
  /// About so long before it turns to the next leg [s].
  [[nodiscard]] double UntilTurn() const;
  /// Of the DVL at its lever arm, in body axes.
  [[nodiscard]] Eigen::Vector3d VelocityOf(const Eigen::Vector3d& arm) const;

 private:
  void PlanLegs();
  const StreamScene& scene_;
  const SimulatedGround& ground_;
  Random random_;
  SlowNoise roll_{random_, 0.03, 6.0}, pitch_{random_, 0.03, 6.0};
  TidalCurrent current_;
  Pose X_;
  Eigen::Vector3d v_W_ = Eigen::Vector3d::Zero();
  double leg_speed_;
  double rate_ = 0.0, speed_ = 0.0, sink_ = 0.0;
  bool is_up_ = true, is_across_ = false;
  std::vector<Eigen::Vector2d> waypoints_;
};

/// When the DVL has no bottom lock, or says one wrong velocity for seconds.
class DvlTroubles {
 public:
  DvlTroubles(const StreamScene& scene, Random& dropouts);
  /// In order of time. REQUIRES: `t` grows.
  [[nodiscard]] bool IsInDropout(double t, const SimulatedVehicle& vehicle);
  /// What the velocity is off then.
  [[nodiscard]] Eigen::Vector3d FalsePart(double t) const;

 private:
  struct Interval {
    double start, end;
  };
  struct Burst {
    Interval when;
    Eigen::Vector3d off;
  };
  Random random_;
  std::optional<double> turn_lead_;  ///< of the next dropout before its turn [s], if it has one
  bool is_turn_due_ = false;
  std::vector<Interval> dropouts_;  ///< still to come or under way
  std::vector<Burst> bursts_;
};

}  // namespace limpet
