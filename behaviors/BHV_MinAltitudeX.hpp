// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Keeps the vehicle off the seabed: all depths that leave `min_altitude` above it are as good.
/// The altitude is the navigation's, or NAV_ALTITUDE where that has none. Parameters are spelled as
/// existing MOOS-IvP missions spell them.
class BHV_MinAltitudeX final : public Behavior {
 public:
  struct Params {
    Meters min_altitude{0.0};
    bool is_missing_critical = true;
    void Describe(ParamCollector& visit);
  };
  explicit BHV_MinAltitudeX(const Params& params) : params_(params) {}
  [[nodiscard]] std::vector<std::string> Variables() const override { return {"NAV_ALTITUDE"}; }
  [[nodiscard]] bool IsConstraint() const override { return true; }
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;

 private:
  Params params_;
};

}  // namespace limpet
