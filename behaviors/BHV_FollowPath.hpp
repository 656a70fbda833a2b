// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Steers along the path that the helm chose, at survey speed. Silent while there is none.
class BHV_FollowPath final : public Behavior {
 public:
  struct Params {
    MetersPerSecond speed{0.5};
    Radians course_skirt = Radians::FromTextUnit(180.0);
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit.Required("speed_mps", speed, "Speed along the path",
                     InRange(MetersPerSecond(0.05), MetersPerSecond(5.0)));
      visit("course_skirt_deg", course_skirt, "Preference falls to nothing this far off course",
            InRange(Radians::FromTextUnit(1.0), Radians::FromTextUnit(180.0)));
    }
  };
  explicit BHV_FollowPath(const Params& params) : params_(params) {}
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;

 private:
  Params params_;
};

}  // namespace limpet
