// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Vetoes options that leave the operating region (area and margin), and steers back inside should
/// the vehicle have left it. A vehicle that starts outside may use options that lead it in.
class BHV_OpRegion final : public Behavior {
 public:
  struct Params {
    Meters tolerance{0.5};
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("tolerance_m", tolerance, "Further outside than this raises the alarm and turns back",
            InRange(Meters(0.0), Meters(20.0)));
    }
  };
  explicit BHV_OpRegion(const Params& params) : params_(params) {}
  [[nodiscard]] MotionBid Move(const VehicleState& state) override;
  [[nodiscard]] std::optional<Bid> Value(const Prospect& prospect,
                                         const Situation& now) const override;

 private:
  Params params_;
};

}  // namespace limpet
