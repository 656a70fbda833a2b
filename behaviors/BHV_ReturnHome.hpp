// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Asks for the way home. With `when = now` it values every option by how far from home it would
/// leave the vehicle; with `when = late` it charges options that would make the vehicle overrun its
/// range on the way back, and refuses those after which the battery (ENERGY_STATE) does not reach
/// home with its reserve.
class BHV_ReturnHome final : public Behavior {
 public:
  struct Params {
    std::string when = "now";
    Meters range{5000.0};
    double lateness_weight = 10.0;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit.Choice("when", when, "Go home now, or only when the range runs out", {"now", "late"});
      visit("range_m", range, "Path that the energy allows, way home included",
            InRange(Meters(10.0), Meters(1e6)));
      visit("lateness_weight", lateness_weight, "Cost of each metre beyond the range",
            InRange(0.0, 1000.0));
    }
  };
  explicit BHV_ReturnHome(const Params& params) : params_(params) {}
  [[nodiscard]] bool WantsView() const override { return params_.when == "now"; }
  void Shape(const Situation& now, double weight, SearchGoals& goals) const override;
  [[nodiscard]] std::optional<Bid> Value(const Prospect& prospect,
                                         const Situation& now) const override;

 private:
  Params params_;
};

}  // namespace limpet
