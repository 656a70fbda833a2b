// SPDX-License-Identifier: MIT
#include <vector>

#include "limpet/helm/generator_registry.hpp"
#include "limpet/helm/plan_task.hpp"
#include "limpet/planning/mission_plan.hpp"

namespace limpet {
namespace {

/// The plan of the whole remaining mission, sought from lanes by random edits and kept from
/// decision to decision; the others' options are completed by it.
class PlanGenerator final : public OptionGenerator {
 public:
  struct Params {
    /// Above TourGoal's: ground that a plan leaves out at its end is fetched by detours, if at all,
    /// and costs less where the plan is laid for it from the first (docs/coverage.md).
    double finish_share = 0.99;
    MissionPlanParams plan;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("plan_finish_share", finish_share,
            "Generator plan: share of the band's top at which the survey is planned to end",
            InRange(0.5, 1.0));
      visit("plan_first_edits", plan.first_edits,
            "Generator plan: random edits tried for a new plan", InRange(0, 1000000));
      visit("plan_edits", plan.edits, "Generator plan: random edits tried at each later decision",
            InRange(0, 1000000));
      visit("plan_warmth_m", plan.warmth,
            "Generator plan: plans about this much longer are gone on from at first",
            InRange(Meters(0.01), Meters(100.0)));
    }
  };
  PlanGenerator(const Params& params, const Random& random)
      : finish_share_(params.finish_share), plan_(params.plan, random) {}

  void Offer(const Situation& now, const SearchGoals& goals,
             std::vector<Option>& options) override {
    plan_.Offer(PlanTaskOf(now, goals, finish_share_), "plan", options);
  }
  void Complete(std::vector<Option>& options) override { plan_.Complete(options); }
  void OnChoice(const Option& option) override { plan_.OnChoice(option); }

 private:
  double finish_share_;
  MissionPlan plan_;
};

}  // namespace

LIMPET_REGISTER_GENERATOR(PlanGenerator, "plan");

}  // namespace limpet
