// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/act_list.hpp"
#include "limpet/helm/behavior.hpp"
#include "limpet/shapes/visual_hints.hpp"

namespace limpet {

/// Stays near a point: goes back when it is further off than its radii allow, at a speed that grows
/// with the distance. Parameters, status variables and hints are spelled as existing MOOS-IvP
/// missions spell them; docs/everyday.md.
class BHV_StationKeep final : public Behavior {
 public:
  struct Params {
    std::optional<MapPoint> station{};
    bool is_center_activated = false;
    Seconds swing_time{0.0};
    Meters inner_radius{4.0}, outer_radius{15.0};
    MetersPerSecond outer_speed{1.2}, transit_speed{2.5};
    std::optional<Meters> hibernation_radius{};
    VisualHints hints{};
    void Describe(ParamCollector& visit);
  };
  explicit BHV_StationKeep(const Params& params) : params_(params) {}

  [[nodiscard]] bool TakeOver(const Behavior& former,
                              const std::vector<std::string>& keys) override;
  void Start(const VehicleState& state) override;
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;
  [[nodiscard]] std::vector<BehaviorAct> Stop(const VehicleState& state) override;

 private:
  /// What it does about the distance while it is allowed to drift far.
  enum class Rest { kHibernating, kSeeking, kClosing };
  struct Watch {
    std::optional<MapPoint> station;
    std::optional<Seconds> swings_until;  ///< the station moves along until then
    bool is_center_due = false;           ///< an update wants it where the vehicle is
    Rest rest = Rest::kHibernating;
    std::deque<std::pair<Seconds, double>> distances;  ///< of the last seconds [m]
  };

  [[nodiscard]] bool MayRest(double distance, Seconds now);
  /// Metres per second that the distance grew by lately; nothing while too little is known.
  [[nodiscard]] std::optional<double> Drift() const;
  [[nodiscard]] double Speed(double distance) const;
  [[nodiscard]] double outer_radius() const;
  void Draw(const VehicleState& state, bool is_active, ActList& acts) const;

  Params params_;
  Watch watch_;
};

}  // namespace limpet
