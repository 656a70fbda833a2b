// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/act_list.hpp"
#include "limpet/helm/behavior.hpp"
#include "limpet/helm/uneven_speed.hpp"
#include "limpet/shapes/visual_hints.hpp"
#include "limpet/waypoints/convex_polygon.hpp"
#include "limpet/waypoints/polygon_entry.hpp"
#include "limpet/waypoints/waypoint_progress.hpp"

namespace limpet {

/// Goes round a convex polygon until told otherwise. Parameters, status variables and hints are
/// spelled as existing MOOS-IvP missions spell them; docs/everyday.md.
class BHV_Loiter final : public Behavior {
 public:
  struct Params {
    std::optional<ConvexPolygon> polygon{};
    MetersPerSecond speed{0.0};
    std::optional<MetersPerSecond> speed_alt{};
    bool uses_alt_speed = false;
    std::string clockwise = "true";  ///< true, false or best
    CaptureRule capture{};
    Meters acquire_distance{10.0};
    std::string center_assign{};  ///< `present_position`, `x,y`, `x=..,y=..`
    std::optional<double> center_x{}, center_y{};
    double growth = 0.0;  ///< of `mod_poly_rad` [m]
    bool is_center_activated = false;
    std::optional<Radians> slingshot{};  ///< completes after so much of a round; nothing: never
    double spiral_factor = 100.0;
    double patience = 50.0;
    bool prefers_slower = false;  ///< of speeds: `ipf_type = zaic_spd`
    std::string suffix{};
    VisualHints hints{};
    void Describe(ParamCollector& visit);
  };
  explicit BHV_Loiter(const Params& params);

  [[nodiscard]] std::optional<std::string> Macro(std::string_view name,
                                                 const VehicleState& state) const override;
  [[nodiscard]] bool TakeOver(const Behavior& former,
                              const std::vector<std::string>& keys) override;
  void Complete(const VehicleState& state) override;
  void Start(const VehicleState& state) override;
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;
  [[nodiscard]] std::vector<BehaviorAct> Idle(const VehicleState& state) override;
  [[nodiscard]] std::vector<BehaviorAct> Stop(const VehicleState& state) override;

 private:
  struct Rounds {
    std::optional<ConvexPolygon> polygon;
    WaypointProgress progress;
    bool is_clockwise = true;
    bool is_acquiring = true;
    bool is_center_due = false;  ///< at the present position, once it runs
    std::string mode = "idle";
    std::optional<double> last_bearing;
    double swept = 0.0;              ///< angle round the center [rad]
    bool is_completion_due = false;  ///< it has completed, and is to say so
    bool has_been_idle = false;
  };

  void AssignCenter(const std::vector<std::string>& keys);
  void LayCorners();
  void BidOnSpeed(double speed, const VehicleState& state, MotionBid& bid);
  void SetMode(double outside);
  void Enter(const MapPose& vehicle);
  /// Counts the angle that it has come round, and tells it; true if that is as much as asked.
  [[nodiscard]] bool IsSlungRound(const MapPoint& at, ActList& acts);
  /// Once after each completion.
  void TellCompletion(ActList& acts);
  [[nodiscard]] std::vector<BehaviorAct> Ended(const VehicleState& state);
  void PostStatus(const VehicleState& state, ActList& acts) const;
  void Draw(const VehicleState& state, bool is_active, ActList& acts) const;

  Params params_;
  Rounds rounds_;
  UnevenSpeed uneven_speed_;
};

}  // namespace limpet
