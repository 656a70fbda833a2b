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
#include "limpet/waypoints/map_geometry.hpp"

namespace limpet {

/// Turns to and fro about a heading, the stem, by one angle to either side, so many times.
/// Parameters, flags, macros and hints are spelled as existing MOOS-IvP missions spell them;
/// docs/everyday.md.
class BHV_ZigZag final : public Behavior {
 public:
  struct Params {
    Radians stem_heading{0.0};
    bool takes_heading = false, takes_speed = false;  ///< from the vehicle, as it begins to run
    MetersPerSecond speed{0.0};
    std::optional<double> speed_change{};  ///< of `mod_speed` [m/s]; absent: reset
    Radians threshold{0.0}, angle{0.0};
    std::optional<Radians> fierce_angle{};
    bool is_fierce = false, begins_to_port = true;
    int legs = 2;
    std::optional<Meters> longest_stem{};  ///< nothing: no limit
    std::vector<Flag> zig_flags{}, zag_flags{}, port_flags{}, starboard_flags{};
    std::vector<Flag> port_end_flags{}, starboard_end_flags{};
    VisualHints hints{};
    void Describe(ParamCollector& visit);
  };
  explicit BHV_ZigZag(const Params& params) : params_(params) {}

  [[nodiscard]] std::optional<std::string> Macro(std::string_view name,
                                                 const VehicleState& state) const override;
  [[nodiscard]] bool TakeOver(const Behavior& former,
                              const std::vector<std::string>& keys) override;
  void Start(const VehicleState& state) override;
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;
  [[nodiscard]] std::vector<BehaviorAct> Stop(const VehicleState& state) override;

 private:
  enum class Side { kStem, kPort, kStarboard };
  /// State of one zigzag, from when it begins to run.
  struct Run {
    Side side = Side::kStem;
    double stem = 0.0;                  ///< heading [rad]
    double speed = 0.0;                 ///< asked for [m/s]
    double begin_speed = 0.0;           ///< without changes that updates made [m/s]
    int legs = 0, legs_ever = 0;        ///< turns finished
    MapPoint from, last;                ///< where it began; where the vehicle was last
    double odo = 0.0;                   ///< travelled [m]
    double leg_odo = 0.0;               ///< in this leg
    double pair_odo = 0.0;              ///< in this pair of legs
    double leg_begin_speed = 0.0;       ///< of the vehicle [m/s]
    std::optional<double> least_speed;  ///< in this leg [m/s]
    bool is_over = false;
  };

  void Travel(const VehicleState& state);
  /// The next leg, on its other side.
  void Turn(Side side, const VehicleState& state, ActList& acts);
  [[nodiscard]] bool HasTurned(double heading) const;
  void FinishLeg(const VehicleState& state, ActList& acts);
  [[nodiscard]] bool IsDone() const;
  /// The heading of this leg [rad].
  [[nodiscard]] double Target() const;
  [[nodiscard]] double Steered(double heading) const;
  [[nodiscard]] MapLeg Stem() const;
  void Draw(const VehicleState& state, bool is_active, ActList& acts) const;

  Params params_;
  Run run_;
  UnevenSpeed uneven_speed_;
};

}  // namespace limpet
