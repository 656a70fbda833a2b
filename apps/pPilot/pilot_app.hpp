// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>

#include "apps/pPilot/plausible.hpp"
#include "limpet/app/app.hpp"
#include "limpet/control/pilot.hpp"
#include "limpet/core/params.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/safety.hpp"

namespace limpet {

/// Flies what the helm wants: DESIRED_* and NAV_STATE in, THRUSTER_COMMAND out. Without a fresh
/// estimate or without fresh wishes it stops all thrusters, and the vehicle floats up. It says its
/// command, zero too, at every tick, for the driver's watchdog; under manual override only once.
/// SAFETY_ACTION it obeys by itself, whatever the helm wants or if that is silent.
class PilotApp final : public App {
 public:
  struct Params {
    Seconds stale_after{1.0};
    double heading_gain = HeadingController::Gains{}.heading;
    double heading_rate_gain = HeadingController::Gains{}.rate;
    RadiansPerSecond max_turn_rate{HeadingController::Gains{}.max_rate};
    double speed_gain = SpeedController::Gains{}.speed;
    double depth_gain = DepthController::Gains{}.depth;
    double depth_rate_gain = DepthController::Gains{}.rate;
    MetersPerSecond max_dive_speed{DepthController::Gains{}.max_rate};
    Meters afloat_depth{DepthController::Gains{}.afloat_depth};
    Newtons max_sway{SwayController::Gains{}.max_force};
    MetersPerSecond degraded_speed{0.25};

    template <class Visitor>
    void Describe(Visitor& visit) {
      using namespace literals;
      visit("stale_after_s", stale_after, "Thrusters stop when NAV_STATE or DESIRED_* are older",
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
      visit("afloat_depth_m", afloat_depth, "Shallower than this, buoyancy holds the vehicle",
            InRange(0.0_m, 2.0_m));
      visit("max_sway_n", max_sway, "Greatest side force", InRange(0.0_n, 100.0_n));
      visit("degraded_speed_mps", degraded_speed, "Greatest speed while SAFETY_ACTION is degrade",
            InRange(0.0_mps, 5.0_mps));
    }
  };

  PilotApp(const AppContext& context, const Params& params);
  void Tick(Seconds now) override;
  void Finish(Seconds now) override;
  void Report(ReportLines& report) const override;

 private:
  /// What was last heard, and when by the pilot's own clock: the sender's stamp may be anything.
  template <class T>
  using Latest = std::optional<Stamped<T>>;
  /// Why the thrusters do what they do.
  enum class Mode {
    kFlying,
    kWaiting,
    kManual,
    kHalted,
    kNoWishes,
    kNoNavigation,
    kHolding,   ///< SAFETY_ACTION hold
    kSurfacing  ///< SAFETY_ACTION surface or abort
  };
  /// Heading and depth that the vehicle had where hold began.
  struct HeldPlace {
    double yaw = 0.0, depth = 0.0;
  };

  void OnNav(const Stamped<NavState>& nav);
  void OnHeading(const Stamped<double>& degrees);
  void OnSpeed(const Stamped<double>& speed);
  void OnDepth(const Stamped<double>& depth);
  void OnTurnRate(const Stamped<double>& rate);
  void OnOverride(const Stamped<bool>& is_manual) { is_manual_ = is_manual.value; }
  void OnAllStop(const Stamped<std::string>& why) { is_halted_ = why.value != topics::kNoAllStop; }
  void OnSafety(const Stamped<std::string>& action);
  void HearWish(const std::string& name, double value, const PlausibleRange& range,
                Latest<double>& wish);
  void Refuse(const std::string& name, const std::string& what);

  template <class T>
  [[nodiscard]] bool IsFresh(const Latest<T>& latest, Seconds now) const {
    return latest && now - latest->time <= params_.stale_after;
  }
  /// A clock that was set back must not make anything young.
  void KeepUp(Seconds now);
  [[nodiscard]] Mode Judge(Seconds now) const;
  void WarnOf(Mode mode);
  [[nodiscard]] DesiredMotion Desired(Seconds now) const;
  /// Commands the thrusters by the control laws, in the present mode.
  void Fly(Seconds now);
  [[nodiscard]] ThrusterCommand Control(Seconds now, double dt);
  [[nodiscard]] bool IsControlled(Seconds now) const;
  void Rest();
  [[nodiscard]] const char* ModeText() const;

  Params params_;
  Pilot pilot_;
  Latest<NavState> nav_;
  Latest<double> heading_, speed_, depth_, turn_rate_;
  bool is_manual_ = false;
  bool is_halted_ = false;  ///< the helm has said why it wants nothing
  SafetyAction safety_ = SafetyAction::kNone;
  std::optional<HeldPlace> held_;
  Mode mode_ = Mode::kWaiting;
  ThrusterCommand command_;             ///< last one given
  std::optional<Seconds> last_step_;    ///< absent while thrusters rest
  std::map<std::string, int> refused_;  ///< numbers that no sender can mean, by variable
};

}  // namespace limpet
