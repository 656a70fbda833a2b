// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"
#include "limpet/helm/revisit_policy.hpp"

namespace limpet {

/// Values what another look would tell about each object's status: the expected drop of the
/// posterior's entropy, earlier looks more (docs/references.md). Former objects that nobody has
/// looked at yet come first in a change session, because their status is the least known. The worth
/// falls to zero by itself once an object has been looked at; a look is what the map counts as one
/// (`survey/look.hpp`). Looks that were flown and told nothing halve it, until the object is given
/// up.
class BHV_RevisitOpi final : public Behavior {
 public:
  struct Params {
    RevisitPolicy::Params policy;
    Meters decay{100.0};
    template <class Visitor>
    void Describe(Visitor& visit) {
      policy.Describe(visit);
      visit("decay_m", decay, "Path after which a look is worth nothing more",
            InRange(Meters(10.0), Meters(10000.0)));
    }
  };
  explicit BHV_RevisitOpi(const Params& params) : policy_(params.policy), decay_(params.decay) {}
  [[nodiscard]] bool IsAboutObjects() const override { return true; }
  [[nodiscard]] bool WantsView() const override { return true; }
  void Shape(const Situation& now, double weight, SearchGoals& goals) const override;
  [[nodiscard]] std::optional<Bid> Value(const Prospect& prospect,
                                         const Situation& now) const override;
  [[nodiscard]] std::vector<RevisitInterest> Interests(const Situation& now) const override {
    return policy_.Interests(now);
  }

 private:
  RevisitPolicy policy_;
  Meters decay_;
};

}  // namespace limpet
