// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/act_list.hpp"
#include "limpet/helm/behavior.hpp"
#include "limpet/helm/rate_of_closure.hpp"
#include "limpet/helm/uneven_speed.hpp"
#include "limpet/shapes/visual_hints.hpp"
#include "limpet/waypoints/lead_point.hpp"
#include "limpet/waypoints/leg_odometer.hpp"
#include "limpet/waypoints/way_drawing.hpp"
#include "limpet/waypoints/waypoint_progress.hpp"

namespace limpet {

/// Travels a list of points, at one speed, once or several times. Parameters, flags, status
/// variables and hints are spelled as existing MOOS-IvP missions spell them; docs/everyday.md.
class BHV_Waypoint final : public Behavior {
 public:
  struct Params {
    std::vector<MapPoint> points{};
    std::string points_from = "list";  ///< start: where the helm began; empty: later, by an update
    MetersPerSecond speed{0.0};
    std::optional<MetersPerSecond> speed_alt{};
    bool uses_alt_speed = false;
    CaptureRule capture{};
    LeadRule lead{};
    bool leads_to_start = false;
    std::vector<Condition> lead_conditions{};
    std::optional<int> repeats = 0;  ///< absent: for ever
    std::string order = "normal";
    std::optional<int> index{};
    std::optional<MapPoint> added{};
    std::vector<Flag> waypoint_flags{}, cycle_flags{};
    bool has_flags_on_start = false;
    std::string status_variable = "WPT_STAT", index_variable = "WPT_INDEX";
    std::string cycle_variable = "CYCLE_INDEX";
    std::string previous_distance_variable{}, next_distance_variable{};
    std::string suffix{};
    double slow_distance = 0.0, stop_distance = 0.0;  ///< of `end_spd` [m]; 0: off
    bool is_greedy = false, is_reset_on_idle = false;
    bool measures_efficiency = false;
    std::string function_kind = "zaic";  ///< of MOOS-IvP's helm
    double patience = 50.0;
    VisualHints hints{};
    void Describe(ParamCollector& visit);
  };
  explicit BHV_Waypoint(Params params);

  [[nodiscard]] std::vector<std::string> Variables() const override;
  [[nodiscard]] std::optional<std::string> Macro(std::string_view name,
                                                 const VehicleState& state) const override;
  [[nodiscard]] bool TakeOver(const Behavior& former,
                              const std::vector<std::string>& keys) override;
  [[nodiscard]] bool IsPerpetual() const override {
    return !params_.repeats || *params_.repeats > 0;
  }
  void Start(const VehicleState& state) override;
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;
  [[nodiscard]] std::vector<BehaviorAct> Stop(const VehicleState& state) override;
  [[nodiscard]] std::vector<BehaviorAct> Idle(const VehicleState& state) override;

 private:
  /// What has been travelled; an update leaves it alone unless it gives other points.
  struct Travel {
    WaypointProgress progress;
    LegOdometer odometer;
    std::optional<MapPoint> begin;  ///< where the first leg is led from
    bool is_reversed = false;
    bool is_greedy_due = false;
    bool has_raised_flags = false;
    std::optional<int> posted_cycles;
    std::optional<std::size_t> posted_index;
  };

  void SetPoints(const Params& params);
  void TakeStart(const VehicleState& state);
  [[nodiscard]] MapPoint SteeringPoint(const VehicleState& state);
  [[nodiscard]] double Speed(const MapPoint& at) const;
  /// Bids for the way to `bearing` [rad], as fast as the way's end allows.
  void Bid(double bearing, const VehicleState& state, MotionBid& bid);
  void BidOnCourse(double bearing, const VehicleState& state, MotionBid& bid) const;
  void BidOnSpeed(double speed, const VehicleState& state, MotionBid& bid);
  void PostProgress(WaypointProgress::Step step, const VehicleState& state, ActList& acts);
  void PostStatus(const VehicleState& state, ActList& acts);
  /// Posts how directly the leg was travelled that has just ended, if it counts.
  void PostEfficiency(const VehicleState& state, ActList& acts);
  [[nodiscard]] double CruiseSpeed() const;
  [[nodiscard]] WayDrawing Drawing(const VehicleState& state) const;
  [[nodiscard]] std::string With(const std::string& variable) const;

  Params params_;
  Travel travel_;
  UnevenSpeed uneven_speed_;
  RateOfClosure closure_;
};

}  // namespace limpet
