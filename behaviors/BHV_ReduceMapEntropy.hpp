// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// ln G of [Bucci 2025]: the entropy of the map inside the images of an option's views (eq. 17), in
/// nats. A view counts what it shows whether or not another one shows it, and length has no price,
/// as printed. For comparison with the paper's planner; BHV_CoverArea surveys better.
class BHV_ReduceMapEntropy final : public Behavior {
 public:
  struct Params {
    bool counts_band = false;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("counts_band", counts_band,
            "Entropy of the whole band of heights, not of the bottom alone");
    }
  };
  explicit BHV_ReduceMapEntropy(const Params& params) : params_(params) {}
  [[nodiscard]] bool WantsView() const override { return true; }
  void Shape(const Situation& now, double weight, SearchGoals& goals) const override;
  [[nodiscard]] std::optional<Bid> Value(const Prospect& prospect,
                                         const Situation& now) const override;

 private:
  Params params_;
};

}  // namespace limpet
