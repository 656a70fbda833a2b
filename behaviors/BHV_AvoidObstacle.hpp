// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/act_list.hpp"
#include "limpet/helm/behavior.hpp"
#include "limpet/shapes/visual_hints.hpp"
#include "limpet/waypoints/convex_polygon.hpp"

namespace limpet {

/// Keeps clear of an obstacle that it is told: bids on courses and speeds together, by how near a
/// straight way would come. Once near, it keeps to the side on which it passes. Also called
/// BHV_AvoidObstacleV24, V21 and X. Parameters, flags, macros and hints
/// are spelled as existing MOOS-IvP missions spell them; docs/everyday.md.
class BHV_AvoidObstacle final : public Behavior {
 public:
  struct Params {
    std::optional<ConvexPolygon> polygon{};
    std::string label{}, id{};
    std::string source{};          ///< who has seen it, as its poly says (`vsource`)
    Seconds allowable_time{20.0};  ///< an approach that is further off in time counts half
    std::optional<double> least_approach{}, free_approach{};                   ///< [m]
    std::optional<double> inner_distance{}, outer_distance{}, end_distance{};  ///< [m]
    bool draws_least = true, draws_free = true;
    bool stops_inside = true;      ///< in place of leading out
    bool can_be_silenced = false;  ///< by mail, `can_disable`
    std::vector<Flag> range_flags{}, approach_flags{};
    VisualHints hints{};
    void Describe(ParamCollector& visit);

    // What is not given fits what is.
    [[nodiscard]] double least() const;
    [[nodiscard]] double free() const;
    [[nodiscard]] double inner() const;
    [[nodiscard]] double outer() const;
    [[nodiscard]] double end() const;
  };
  explicit BHV_AvoidObstacle(const Params& params) : params_(params) {}

  [[nodiscard]] std::vector<std::string> Variables() const override;
  /// Asks MOOS-IvP's pObstacleMgr for obstacles from `pwt_outer_dist` on.
  [[nodiscard]] std::optional<BehaviorPost> Request(const std::string& updates) const override;
  [[nodiscard]] std::optional<std::string> Macro(std::string_view name,
                                                 const VehicleState& state) const override;
  [[nodiscard]] bool TakeOver(const Behavior& former,
                              const std::vector<std::string>& keys) override;
  void Start(const VehicleState& state) override;
  [[nodiscard]] bool IsConstraint() const override { return true; }
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;
  [[nodiscard]] std::vector<BehaviorAct> Stop(const VehicleState& state) override;
  [[nodiscard]] std::vector<BehaviorAct> Idle(const VehicleState& state) override;

 private:
  /// What it has seen of the vehicle's passage.
  struct Passage {
    std::optional<Seconds> began;
    std::optional<double> nearest_ever;  ///< [m]
    double extreme = 0.0;                ///< nearest while it closes, farthest while it opens [m]
    bool is_closing = false;
    bool is_resolved = false;                       ///< so pObstacleMgr says
    bool is_silenced = false, is_expunged = false;  ///< by BHV_ABLE_FILTER
    bool was_near = false;                          ///< within the distance at which it ends
    double reported = 0.0;                          ///< of the last approach, for its flags [m]
    /// Where the obstacle lies while the vehicle passes it, which is to stay so.
    enum class Side { kOpen, kPort, kStarboard } side = Side::kOpen;
  };

  [[nodiscard]] double Range(const VehicleState& state) const;
  /// How near the obstacle is: from 0 at the outer distance to 1 at the inner one.
  [[nodiscard]] double Nearness(double range) const;
  /// Bearing of the obstacle's middle from the bow, to starboard [rad].
  [[nodiscard]] double Off(const VehicleState& state, double course) const;
  void KeepSide(const VehicleState& state, double relevance);
  [[nodiscard]] bool ChangesSide(const VehicleState& state, double course) const;
  /// Flags of range and approach; true if the obstacle is of no more concern.
  [[nodiscard]] bool Watch(const VehicleState& state, ActList& acts);
  [[nodiscard]] bool HasPassed(double range);
  /// What pObstacleMgr says of obstacles since this one is guarded.
  void HearManager(const VehicleState& state, ActList& acts);
  /// `action=disable,obstacle_id=7` and the like: silences it, or gives it its say again.
  void HearFilter(std::string_view text);
  /// How much it matters, from 0 to 1: by distance, and by how much ahead it lies.
  [[nodiscard]] double Relevance(const VehicleState& state) const;
  void FillTable(const VehicleState& state, double relevance);
  void Draw(bool is_active, ActList& acts) const;

  Params params_;
  Passage passage_;
  std::optional<MotionTable> table_;
};

}  // namespace limpet
