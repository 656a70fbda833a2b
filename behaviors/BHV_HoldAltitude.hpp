// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Prefers depths that keep the vehicle `altitude_m` above the seabed. Bottom lock that was lost
/// holds the last seabed for `memory_s`, by default longer than pSafety's rule dvl_lost waits;
/// after that it is silent, so that other behaviors decide the depth.
class BHV_HoldAltitude final : public Behavior {
 public:
  struct Params {
    Meters altitude{4.0};
    Meters tolerance{0.0};
    Meters skirt{5.0};
    Seconds smoothing{2.0};
    Seconds memory{120.0};
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit.Required("altitude_m", altitude, "Height to keep above the seabed",
                     InRange(Meters(0.3), Meters(100.0)));
      visit("tolerance_m", tolerance, "Depths this near are as good",
            InRange(Meters(0.0), Meters(10.0)));
      visit("skirt_m", skirt, "Preference falls to nothing over this depth",
            InRange(Meters(0.1), Meters(100.0)));
      visit("smoothing_s", smoothing, "Time constant over which the seabed is averaged",
            InRange(Seconds(0.0), Seconds(60.0)));
      visit("memory_s", memory, "A lost seabed is believed for this long",
            InRange(Seconds(0.0), Seconds(600.0)));
    }
  };
  explicit BHV_HoldAltitude(const Params& params) : params_(params) {}
  void Start(const VehicleState& state) override;
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;

 private:
  void TrackSeabed(const VehicleState& state);
  Params params_;
  std::optional<double> seabed_down_;  ///< smoothed NED depth of the seabed below [m]
  Seconds seen_at_;
};

}  // namespace limpet
