// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Stays at its station: for fixes at the surface, the dive and the ascent. Stops and keeps its
/// heading; what carried the vehicle further off than `radius_m` it makes good by going back. With
/// `station = here` that is where it began, and the way made good is the integral of the velocity
/// over ground, so that a fix that moves the estimate does not move the vehicle. With `station =
/// home` it is the point of SURVEY_HOME: after the dive a fix shows how far that really is.
class BHV_HoldStation final : public Behavior {
 public:
  struct Params {
    std::string station = "here";
    Meters radius{1.0};
    MetersPerSecond speed{0.3};
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit.Choice("station", station, "Where: here, as it begins, or home once that is known",
                   {"here", "home"});
      visit("radius_m", radius, "Goes back when carried further off than this",
            InRange(Meters(0.2), Meters(100.0)));
      visit("speed_mps", speed, "Fastest speed on the way back",
            InRange(MetersPerSecond(0.05), MetersPerSecond(3.0)));
    }
  };
  explicit BHV_HoldStation(const Params& params) : params_(params) {}
  void Start(const VehicleState& state) override;
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;

 private:
  void TrackOffset(const VehicleState& state);
  Params params_;
  std::optional<double> heading_;
  Eigen::Vector2d offset_W_ = Eigen::Vector2d::Zero();  ///< from the station, north and east [m]
  bool is_returning_ = false;
  std::optional<Seconds> last_;
};

}  // namespace limpet
