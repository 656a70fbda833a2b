// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Prefers one depth. Parameters are spelled as existing MOOS-IvP missions spell them.
class BHV_ConstantDepth final : public Behavior {
 public:
  struct Params {
    Meters depth{0.0};
    Meters peakwidth{0.0};
    Meters basewidth{2.0};
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("depth", depth, "Depth to keep", InRange(Meters(0.0), Meters(6000.0)));
      visit("peakwidth", peakwidth, "Depths this near are as good", AtLeast(Meters(0.0)));
      visit("basewidth", basewidth, "Preference falls to nothing over this depth",
            AtLeast(Meters(0.01)));
    }
  };
  explicit BHV_ConstantDepth(const Params& params) : params_(params) {}
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;

 private:
  Params params_;
};

}  // namespace limpet
