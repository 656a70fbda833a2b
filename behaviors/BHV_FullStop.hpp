// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/act_list.hpp"
#include "limpet/helm/behavior.hpp"
#include "limpet/shapes/visual_hints.hpp"

namespace limpet {

/// Stops the vehicle on the heading that it has as it begins to run, and completes once it stands
/// or drifts back. Parameters, flags, macros and hints are spelled as existing MOOS-IvP missions
/// spell them; docs/everyday.md.
class BHV_FullStop final : public Behavior {
 public:
  struct Params {
    MetersPerSecond stop_threshold{0.1};
    Seconds mark_duration{0.0}, complete_delay{0.0};
    std::vector<Flag> mark_flags{}, unmark_flags{};
    VisualHints hints{};
    void Describe(ParamCollector& visit);
  };
  explicit BHV_FullStop(const Params& params) : params_(params) {}

  [[nodiscard]] std::optional<std::string> Macro(std::string_view name,
                                                 const VehicleState& state) const override;
  [[nodiscard]] bool TakeOver(const Behavior& former,
                              const std::vector<std::string>& keys) override;
  void Start(const VehicleState& state) override;
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;
  [[nodiscard]] std::vector<BehaviorAct> Stop(const VehicleState& state) override;

 private:
  /// One stop, from when it begins to run.
  struct Braking {
    Seconds began{0.0};
    MapPoint from, last;    ///< where it began; where the vehicle was last
    double heading = 0.0;   ///< [rad]
    double way = 0.0;       ///< travelled [m]
    double farthest = 0.0;  ///< from where it began [m]
    bool is_marked = false, is_unmarked = false;
    bool is_over = false;            ///< it has completed
    std::optional<Seconds> stopped;  ///< since when it stands
  };
  void RaiseMarks(const VehicleState& state, ActList& acts);
  [[nodiscard]] bool IsStopped(const VehicleState& state);
  [[nodiscard]] std::vector<BehaviorAct> Draw(const VehicleState& state, bool is_active) const;

  Params params_;
  Braking braking_;
};

}  // namespace limpet
