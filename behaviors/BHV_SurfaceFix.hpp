// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Comes up for a fix where the operating region cannot be kept otherwise. It charges every option
/// for the way on which three sigmas of the vehicle's place reach over a border of the region or of
/// a keep-out zone and after a fix would not, and offers the first options once more, to be flown
/// after a fix, for what that costs in metres of path. Once one of those is chosen it posts
/// SURFACE_FIX = true, by which a mission's modes bring the vehicle up and hold it there, and
/// SURFACE_FIX = false when the place is known well enough.
class BHV_SurfaceFix final : public Behavior {
 public:
  struct Params {
    Meters fix_sigma{0.5};
    double doubt_weight = 1.0;
    Meters pays_over{100.0}, surface_depth{0.35};
    MetersPerSecond speed{0.5}, ascent_speed{0.25};
    Seconds shortest_stay{20.0}, longest_stay{120.0}, pause{300.0};
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("fix_sigma_m", fix_sigma, "1-sigma of the place that a fix brings, on either axis",
            InRange(Meters(0.01), Meters(100.0)));
      visit(
          "doubt_weight", doubt_weight,
          "Cost of a metre of way by each metre that three sigmas reach over a border and after a "
          "fix would not",
          InRange(0.0, 1000.0));
      visit("pays_over_m", pays_over, "Way over which a fix is reckoned to pay",
            InRange(Meters(1.0), Meters(1e5)));
      visit("surface_depth_m", surface_depth, "Shallower than this is at the surface",
            InRange(Meters(0.0), Meters(5.0)));
      visit("speed_mps", speed, "Survey speed: turns time spent on a fix into metres",
            InRange(MetersPerSecond(0.05), MetersPerSecond(5.0)));
      visit("ascent_mps", ascent_speed, "Speed of ascent and dive, for what a fix costs",
            InRange(MetersPerSecond(0.02), MetersPerSecond(5.0)));
      visit("shortest_stay_s", shortest_stay, "Least time at the surface",
            InRange(Seconds(0.0), Seconds(3600.0)));
      visit("longest_stay_s", longest_stay,
            "It goes on after so long at the surface, whatever the fixes say",
            InRange(Seconds(1.0), Seconds(3600.0)));
      visit("pause_s", pause, "After coming up it does not offer to again for so long",
            InRange(Seconds(0.0), Seconds(1e5)));
    }
  };
  explicit BHV_SurfaceFix(const Params& params) : params_(params) {}
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;
  [[nodiscard]] std::vector<BehaviorAct> Stop(const VehicleState& state) override;
  void Offer(const Situation& now, std::vector<Option>& options) const override;
  [[nodiscard]] std::optional<Bid> Value(const Prospect& prospect,
                                         const Situation& now) const override;

 private:
  /// The place is known so much worse than after a fix that it has a say.
  [[nodiscard]] bool IsFixWorthwhile() const;
  /// What coming up costs from the present depth [m of path].
  [[nodiscard]] double Cost() const;
  /// How much less far three sigmas would reach over a border after a fix, along `path` [m^2].
  [[nodiscard]] double DoubtSaved(const DubinsPath& path) const;
  /// True once the stay at the surface is over.
  [[nodiscard]] bool HasStayedEnough(const VehicleState& state);

  Params params_;
  std::optional<SurveyArea> area_;
  std::optional<Region> region_;       ///< of that area
  double sigma_ = 0.0, depth_ = 0.0;   ///< [m] as of the last iteration
  bool is_up_ = false;                 ///< on the way up, or there
  std::optional<Seconds> at_surface_;  ///< since when
  std::optional<Seconds> not_before_;  ///< does not offer to come up
};

}  // namespace limpet
