// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/act_list.hpp"
#include "limpet/helm/behavior.hpp"
#include "limpet/helm/uneven_speed.hpp"
#include "limpet/shapes/visual_hints.hpp"
#include "limpet/waypoints/lead_point.hpp"
#include "limpet/waypoints/leg_plan.hpp"
#include "limpet/waypoints/track_crossings.hpp"
#include "limpet/waypoints/waypoint_progress.hpp"

namespace limpet {

/// Travels a leg to and fro, with a turn about beyond each of its ends. Parameters, flags and hints
/// are spelled as existing MOOS-IvP missions spell them; docs/everyday.md.
class BHV_LegRun final : public Behavior {
 public:
  /// What one line makes of the leg or of its turns; lines like `leg_len_mod` change what there is.
  struct Edit {
    std::vector<std::string> keys;  ///< names of the line's key
    bool is_place = false;          ///< says where the leg is: comes before what changes that
    std::function<void(LegPlan&)> apply;
  };
  struct Params {
    std::vector<Edit> edits{};
    CaptureRule capture{};
    double patience = 50.0;
    LeadRule lead{};
    std::optional<int> repeats = 0;  ///< absent: for ever
    MetersPerSecond speed{0.0};
    std::vector<double> leg_speeds{};  ///< [m/s] one per leg, from the second leg on
    bool repeats_speeds = false, keeps_speed_in_turns = false;
    std::string first_leg = "fixed";
    double mid_leg = 25.0, mid_turn = 25.0;  ///< [%] of the way
    std::vector<Flag> leg_flags{}, leg1_flags{}, leg2_flags{}, mid_leg_flags{};
    std::vector<Flag> turn_flags{}, turn1_flags{}, turn2_flags{}, mid_turn_flags{};
    std::vector<Flag> cycle_flags{};
    VisualHints hints{};
    void Describe(ParamCollector& visit);
  };
  explicit BHV_LegRun(Params params);

  [[nodiscard]] std::optional<std::string> Macro(std::string_view name,
                                                 const VehicleState& state) const override;
  [[nodiscard]] bool TakeOver(const Behavior& former,
                              const std::vector<std::string>& keys) override;
  [[nodiscard]] bool IsPerpetual() const override { return true; }
  void Start(const VehicleState& state) override;
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;
  [[nodiscard]] std::vector<BehaviorAct> Stop(const VehicleState& state) override;
  [[nodiscard]] std::vector<BehaviorAct> Idle(const VehicleState& state) override;

 private:
  /// How far it has come.
  struct Run {
    bool is_begun = false;
    bool is_turning = false;
    WaypointProgress legs;  ///< its next point is the end that it goes to, or turns about
    WaypointProgress turn;
    std::size_t turn_end = 0;
    int legs_done = 0;
    bool is_mid_told = false;       ///< of this leg or turn
    std::optional<double> speed{};  ///< of this leg; absent: `speed` [m/s]
    std::size_t next_speed = 0;
    double leg_odo = 0.0;          ///< travelled on this leg [m]
    std::optional<MapPoint> last;  ///< where the vehicle was
    std::string told_mode{};
  };

  /// Begins the run anew, from where the vehicle is.
  void Begin(const MapPoint& at);
  void Advance(const VehicleState& state, ActList& acts);
  void AdvanceLeg(const VehicleState& state, ActList& acts);
  void AdvanceTurn(const VehicleState& state, ActList& acts);
  void TakeSpeed();
  [[nodiscard]] MapPoint SteeringPoint(const MapPoint& at) const;
  [[nodiscard]] const WaypointProgress& way() const {
    return run_.is_turning ? run_.turn : run_.legs;
  }
  /// The end that it goes to or turns about: 0 or 1.
  [[nodiscard]] std::size_t end() const {
    return run_.is_turning ? run_.turn_end : run_.legs.index();
  }
  [[nodiscard]] std::string ModeText() const;
  /// How much of this leg, or turn, is done [%].
  [[nodiscard]] double Share(const MapPoint& at) const;
  /// LR_MODE and its report, whenever it is another one.
  void TellMode(const VehicleState& state, ActList& acts);
  void Draw(const VehicleState& state, bool is_active, ActList& acts) const;

  Params params_;
  LegPlan plan_;
  Run run_;
  TrackCrossings crossings_;  ///< since the last turn
  UnevenSpeed uneven_speed_;
};

}  // namespace limpet
