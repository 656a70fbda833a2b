// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/control/depth_controller.hpp"
#include "limpet/control/drift_estimate.hpp"
#include "limpet/control/heading_controller.hpp"
#include "limpet/control/speed_controller.hpp"
#include "limpet/control/sway_controller.hpp"
#include "limpet/control/thrust_allocation.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"
#include "limpet/vehicle/vehicle_params.hpp"

namespace limpet {

/// What the helm wants now. NED, radians.
struct DesiredMotion {
  double yaw = 0.0;
  std::optional<double> speed;  ///< over ground [m/s]; absent: coast, no surge force
  double depth = 0.0;           ///< [m], positive down
  double turn_rate = 0.0;       ///< feed-forward [rad/s]
};

/// All control laws and the thrust allocation: from estimate and wish to thruster commands. Pure:
/// no clock, no mail.
class Pilot {
 public:
  struct Gains {
    HeadingController::Gains heading;
    SpeedController::Gains speed;
    SwayController::Gains sway;
    DriftEstimate::Gains drift;
    DepthController::Gains depth;
  };
  Pilot(const Gains& gains, const VehicleParams& vehicle);

  /// One control step, `dt` [s] after the last.
  [[nodiscard]] ThrusterCommand Update(const NavState& nav, const DesiredMotion& desired,
                                       double dt);
  /// One control step when only the way up is left: heave upwards alone, no thrust ahead, aside or
  /// about.
  [[nodiscard]] ThrusterCommand Rise(const NavState& nav, double dt);
  /// Forgets what integrals and references hold; for after an interruption.
  void Reset(const NavState& nav);
  [[nodiscard]] bool is_saturated() const { return is_saturated_; }

 private:
  /// Surge and sway force [N].
  [[nodiscard]] Eigen::Vector2d HorizontalForce(const NavState& nav, const DesiredMotion& desired,
                                                double dt);
  [[nodiscard]] Wrench WantedWrench(const NavState& nav, const DesiredMotion& desired, double dt);
  /// Heave force towards `depth` [N], down positive.
  [[nodiscard]] double HeaveForce(const NavState& nav, Meters depth, double dt);
  [[nodiscard]] ThrusterCommand Allocate(const Wrench& wanted);

  HeadingController heading_;
  SpeedController speed_;
  SwayController sway_;
  DriftEstimate drift_;
  DepthController depth_;
  ThrustAllocation allocation_;
  std::size_t thrusters_;                                ///< that the vehicle has
  Eigen::Vector2d current_B_ = Eigen::Vector2d::Zero();  ///< as estimated in the last step [m/s]
  bool is_saturated_ = false;
};

}  // namespace limpet
