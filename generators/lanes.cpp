// SPDX-License-Identifier: MIT
#include <vector>

#include "limpet/helm/generator_registry.hpp"
#include "limpet/helm/plan_task.hpp"
#include "limpet/planning/mission_plan.hpp"

namespace limpet {
namespace {

/// The conventional survey: parallel lanes as far apart as the band's top is wide, in the direction
/// and the order that make the shortest way, flown as they are. What others offer is completed by
/// the lanes that are left.
class LaneGenerator final : public OptionGenerator {
 public:
  struct Params {
    double finish_share = TourGoal{}.finish_share;
    template <class Visitor>
    void Describe(Visitor& visit) {
      visit("lanes_finish_share", finish_share,
            "Generator lanes: share of the band's top at which the survey is planned to end",
            InRange(0.5, 1.0));
    }
  };
  LaneGenerator(const Params& params, const Random& random)
      : finish_share_(params.finish_share),
        plan_({.lanes = {.with_bottom_first = false}, .seeds = 1, .first_edits = 0, .edits = 0},
              random) {}

  void Offer(const Situation& now, const SearchGoals& goals,
             std::vector<Option>& options) override {
    MissionPlan::Task task = PlanTaskOf(now, goals, finish_share_);
    task.goal.early_weight = task.goal.most_weight = 0.0;
    plan_.Offer(task, "lanes", options);
  }
  void Complete(std::vector<Option>& options) override { plan_.Complete(options); }
  void OnChoice(const Option& option) override { plan_.OnChoice(option); }

 private:
  double finish_share_;
  MissionPlan plan_;
};

}  // namespace

LIMPET_REGISTER_GENERATOR(LaneGenerator, "lanes");

}  // namespace limpet
