// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"
#include "limpet/helm/revisit_policy.hpp"

namespace limpet {

/// lambda A of [Bucci 2025], in nats: entropy of the objects inside the images of an option's views
/// (eqs 18, 19, 21) and, as long as little of the area is covered, of those of the former session
/// (eq. 22, weighted as in eq. 23). Without a former session that is eq. (20). Which objects still
/// want a look is decided as BHV_RevisitOpi does.
class BHV_ReduceObjectEntropy final : public Behavior {
 public:
  struct Params {
    double lambda = 1.0;
    RevisitPolicy::Params policy;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("lambda", lambda, "Weight of the object term in eqs (20), (23) of [Bucci 2025]",
            InRange(0.0, 1000.0));
      policy.Describe(visit);
    }
  };
  explicit BHV_ReduceObjectEntropy(const Params& params)
      : lambda_(params.lambda), policy_(params.policy) {}
  [[nodiscard]] bool IsAboutObjects() const override { return true; }
  [[nodiscard]] bool WantsView() const override { return true; }
  [[nodiscard]] std::optional<Bid> Value(const Prospect& prospect,
                                         const Situation& now) const override;
  [[nodiscard]] std::vector<RevisitInterest> Interests(const Situation& now) const override {
    return policy_.Interests(now);
  }

 private:
  double lambda_;
  RevisitPolicy policy_;
};

}  // namespace limpet
