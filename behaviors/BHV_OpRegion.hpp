// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "behaviors/BHV_OpRegionV24.hpp"
#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Vetoes options that leave the operating region or enter a keep-out zone, and steers back inside
/// should the vehicle have left it, or stand before a border with no room to turn as paths do. For
/// a vehicle that is outside, e.g. at its start, it asks for a way in. The region is in force once
/// it has been entered, and no more on the way home, which may end anywhere, but leads through no
/// zone either. Where the vehicle does not know its place well enough to be sure that it is inside,
/// it says so. As missions of MOOS-IvP write it, with a polygon or limits of depth, altitude and
/// time, it stops the vehicle beyond them (BHV_OpRegionV24), with or without a survey.
class BHV_OpRegion final : public Behavior {
 public:
  struct Params {
    Meters tolerance{0.5};
    MetersPerSecond lead_speed{0.25};
    BHV_OpRegionV24::Params limits{};
    void Describe(ParamCollector& visit);
  };
  explicit BHV_OpRegion(const Params& params) : params_(params), limits_(params.limits) {}
  [[nodiscard]] std::vector<std::string> Variables() const override { return limits_.Variables(); }
  [[nodiscard]] std::optional<std::string> Macro(std::string_view name,
                                                 const VehicleState& state) const override {
    return limits_.Macro(name, state);
  }
  [[nodiscard]] bool TakeOver(const Behavior& former,
                              const std::vector<std::string>& keys) override;
  [[nodiscard]] std::vector<BehaviorAct> Idle(const VehicleState& state) override {
    return limits_.Idle(state);
  }
  [[nodiscard]] std::vector<BehaviorAct> Stop(const VehicleState& state) override;
  void Start(const VehicleState& state) override;
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;
  void Shape(const Situation& now, double weight, SearchGoals& goals) const override;
  [[nodiscard]] std::optional<Bid> Value(const Prospect& prospect,
                                         const Situation& now) const override;

 private:
  /// Whether three sigmas of the vehicle's place reach over a border that is `clearance` [m] off.
  [[nodiscard]] bool IsInDoubt(const VehicleState& state, double clearance);

  /// What it says of a survey's area; leaves the limits out.
  void MoveInArea(const VehicleState& state, MotionBid& bid);
  /// Says what the vehicle is beyond, or may be; of zones alone unless it `is_within` the region.
  void WarnOfBorders(const VehicleState& state, bool is_within, MotionBid& bid);
  /// A course farther inside for a vehicle without a path, `outside` [m] of the region.
  void LeadInside(const VehicleState& state, double outside, MotionBid& bid);

  Params params_;
  BHV_OpRegionV24 limits_;
  std::optional<SurveyArea> area_;
  std::optional<Region> region_;  ///< of that area
  bool has_entered_ = false;      ///< has been inside since it began to run
  bool is_in_doubt_ = false;      ///< of being inside
  std::optional<Seconds> without_path_since_;
  std::optional<PlanePoint> lead_to_;  ///< where it is led meanwhile
};

}  // namespace limpet
