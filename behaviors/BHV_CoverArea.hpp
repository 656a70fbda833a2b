// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/params.hpp"
#include "limpet/helm/behavior.hpp"

namespace limpet {

/// Values by how much an option is expected to lower the entropy of the map of the ground, which
/// goes with what it newly shows, each height above each cell once; less what it costs to fly and
/// the ragged border it leaves behind. Metres of path; docs/references.md.
class BHV_CoverArea final : public Behavior {
 public:
  struct Params {
    GroundRates rates = kSurveyRates;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("cover_weight", rates.cover, "Worth of one metre of fully useful track",
            InRange(0.0, 100.0));
      visit("frontier_weight", rates.frontier,
            "Cost of one metre more border between seen and unseen", InRange(0.0, 100.0));
      visit("early_weight", rates.early,
            "Cost of each metre of path before ground is first seen, mean over the area; where "
            "options are compared to the end of the survey",
            InRange(0.0, 100.0));
      visit("most_weight", rates.most,
            "Cost of each metre of path before most of the bottom (0.95) and of the band's top "
            "(0.92) has been seen, by their weights; where "
            "options are compared to the end of the survey",
            InRange(0.0, 100.0));
    }
  };
  explicit BHV_CoverArea(const Params& params) : params_(params) {}
  [[nodiscard]] bool WantsView() const override { return true; }
  void Shape(const Situation& now, double weight, SearchGoals& goals) const override;
  [[nodiscard]] std::optional<Bid> Value(const Prospect& prospect,
                                         const Situation& now) const override;

 private:
  Params params_;
};

}  // namespace limpet
