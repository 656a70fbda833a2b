// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Values the new ground an option would show, each cell once, less what it costs to fly and the
/// ragged border it leaves behind. Metres of path; `paper.md` section 5.
class BHV_CoverArea final : public Behavior {
 public:
  struct Params {
    double cover_weight = 1.0;
    double frontier_weight = 0.5;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("cover_weight", cover_weight, "Worth of one metre of fully useful track",
            InRange(0.0, 100.0));
      visit("frontier_weight", frontier_weight,
            "Cost of one metre more border between seen and unseen", InRange(0.0, 100.0));
    }
  };
  explicit BHV_CoverArea(const Params& params) : params_(params) {}
  [[nodiscard]] bool WantsView() const override { return true; }
  void Shape(const Situation& now, double weight, SearchObjective& objective) const override;
  [[nodiscard]] std::optional<Bid> Value(const Prospect& prospect,
                                         const Situation& now) const override;

 private:
  Params params_;
};

}  // namespace limpet
