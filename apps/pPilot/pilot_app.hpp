// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "apps/pPilot/pilot.hpp"
#include "limpet/app/app.hpp"
#include "limpet/core/params.hpp"

namespace limpet {

/// Flies what the helm wants: DESIRED_* and NAV_STATE in, THRUSTER_COMMAND out. Without a fresh
/// estimate it stops all thrusters (the vehicle floats up); without fresh wishes it stops surge and
/// holds heading and depth.
class PilotApp final : public App {
 public:
  struct Params {
    Seconds stale_after{2.0};
    double heading_gain = HeadingController::Gains{}.heading;
    double heading_rate_gain = HeadingController::Gains{}.rate;
    RadiansPerSecond max_turn_rate{HeadingController::Gains{}.max_rate};
    double speed_gain = SpeedController::Gains{}.speed;
    double depth_gain = DepthController::Gains{}.depth;
    double depth_rate_gain = DepthController::Gains{}.rate;
    MetersPerSecond max_dive_speed{DepthController::Gains{}.max_rate};
    Meters surface_depth{DepthController::Gains{}.surface_depth};
    Newtons max_sway{SwayController::Gains{}.max_force};

    template <class Visitor>
    void Describe(Visitor& visit) {
      using namespace literals;
      visit("stale_after_s", stale_after, "Longest gap in NAV_STATE or DESIRED_*",
            InRange(0.2_s, 60.0_s));
      visit("heading_gain", heading_gain, "Turn rate per heading error [1/s]", InRange(0.05, 5.0));
      visit("heading_rate_gain", heading_rate_gain, "Turn acceleration per rate error [1/s]",
            InRange(0.05, 10.0));
      visit("max_turn_rate_degps", max_turn_rate, "Fastest turn that a heading error asks for",
            InRange(1.0_degps, 90.0_degps));
      visit("speed_gain", speed_gain, "Acceleration per speed error [1/s]", InRange(0.05, 10.0));
      visit("depth_gain", depth_gain, "Acceleration per depth error [1/s^2]", InRange(0.05, 10.0));
      visit("depth_rate_gain", depth_rate_gain, "Acceleration per error of depth rate [1/s]",
            InRange(0.05, 10.0));
      visit("max_dive_speed_mps", max_dive_speed, "Fastest dive and ascent",
            InRange(0.02_mps, 1.0_mps));
      visit("surface_depth_m", surface_depth, "Shallower than this, buoyancy holds the vehicle",
            InRange(0.0_m, 2.0_m));
      visit("max_sway_n", max_sway, "Greatest side force", InRange(0.0_n, 100.0_n));
    }
  };

  PilotApp(const AppContext& context, const Params& params);
  void Tick(Seconds now) override;
  void Report(ReportLines& report) const override;

 private:
  template <class T>
  using Latest = std::optional<Stamped<T>>;

  /// What pNav itself does not vouch for is not flown by.
  void OnNav(const Stamped<NavState>& nav) {
    nav_ = nav.value.is_usable() ? Latest<NavState>(nav) : std::nullopt;
  }
  void OnHeading(const Stamped<double>& degrees) { heading_ = degrees; }
  void OnSpeed(const Stamped<double>& speed) { speed_ = speed; }
  void OnDepth(const Stamped<double>& depth) { depth_ = depth; }
  void OnTurnRate(const Stamped<double>& rate) { turn_rate_ = rate; }
  void OnOverride(const Stamped<bool>& is_manual) { is_manual_ = is_manual.value; }

  template <class T>
  [[nodiscard]] bool IsFresh(const Latest<T>& latest, Seconds now) const {
    return latest && now - latest->time <= params_.stale_after;
  }
  [[nodiscard]] bool MayMove(Seconds now);
  [[nodiscard]] DesiredMotion Desired(Seconds now);
  void Fly(Seconds now);
  void Rest();

  Params params_;
  Pilot pilot_;
  Latest<NavState> nav_;
  Latest<double> heading_, speed_, depth_, turn_rate_;
  bool is_manual_ = false;
  ThrusterCommand command_;           ///< last one given
  std::optional<Seconds> last_step_;  ///< absent while thrusters rest
};

}  // namespace limpet
