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
/// straight way would come. Also called BHV_AvoidObstacleV24. Parameters, flags, macros and hints
/// are spelled as existing MOOS-IvP missions spell them; docs/everyday.md.
class BHV_AvoidObstacle final : public Behavior {
 public:
  struct Params {
    std::optional<ConvexPolygon> polygon{};
    std::string label{}, id{};
    Seconds allowable_time{20.0};  ///< an approach that is further off in time counts half
    std::optional<double> least_approach{}, free_approach{};                   ///< [m]
    std::optional<double> inner_distance{}, outer_distance{}, end_distance{};  ///< [m]
    bool draws_least = true, draws_free = true;
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

  [[nodiscard]] std::vector<std::string> Variables() const override { return {"OBM_RESOLVED"}; }
  [[nodiscard]] std::optional<std::string> Macro(std::string_view name,
                                                 const VehicleState& state) const override;
  [[nodiscard]] bool TakeOver(const Behavior& former,
                              const std::vector<std::string>& keys) override;
  void Start(const VehicleState& state) override;
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
    bool was_near = false;  ///< within the distance at which it ends
    double reported = 0.0;  ///< of the last approach, for its flags [m]
  };

  [[nodiscard]] double Range(const VehicleState& state) const;
  /// Flags of range and approach; true if the obstacle is of no more concern.
  [[nodiscard]] bool Watch(const VehicleState& state, ActList& acts);
  [[nodiscard]] bool HasPassed(double range);
  [[nodiscard]] bool IsResolved(const VehicleState& state) const;
  /// How much it matters, from 0 to 1: by distance, and by how much ahead it lies.
  [[nodiscard]] double Relevance(const VehicleState& state) const;
  void FillTable(const VehicleState& state, double relevance);
  void Draw(bool is_active, ActList& acts) const;

  Params params_;
  Passage passage_;
  std::optional<MotionTable> table_;
};

}  // namespace limpet
