// SPDX-License-Identifier: MIT
#include "limpet/helm/planner_preset.hpp"

#include <gtest/gtest.h>

#include "limpet/helm/behavior_host.hpp"
#include "limpet/helm/registry.hpp"

namespace limpet {
namespace {

/// What runs in the place of BHV_CoverArea with `planner = paper`.
class BHV_ReduceMapEntropy final : public Behavior {
 public:
  struct Params {
    bool counts_band = false;
    template <class V>
    void Describe(V& visit) {
      visit("counts_band", counts_band, "");
    }
  };
  explicit BHV_ReduceMapEntropy(const Params&) {}
};
LIMPET_REGISTER_BEHAVIOR(BHV_ReduceMapEntropy);

std::vector<BehaviorFile> CoverFile() {
  return {ParseBehaviors(R"(
Behavior = BHV_CoverArea
{
  name      = cover
  pwt       = 7
  condition = DEPLOY = true
  frontier_weight = 0.5
}
)",
                         "mission.bhv")};
}

TEST(PlannerPreset, OfLimpetLeavesTheBehaviorsAsTheyAre) {
  std::vector<BehaviorFile> files = CoverFile();
  ApplyStandIns(PresetOf({}), files);
  EXPECT_EQ(files[0].behaviors[0].name, "BHV_CoverArea");
  EXPECT_EQ(files[0].behaviors[0].Find("pwt")->value, "7");
}

TEST(PlannerPreset, OfThePaperKeepsNameAndConditionAndDropsWhatIsInMetres) {
  std::vector<BehaviorFile> files = CoverFile();
  ViewParams params;
  params.planner = "paper";
  ApplyStandIns(PresetOf(params), files);
  const ConfigBlock& block = files[0].behaviors[0];
  EXPECT_EQ(block.name, "BHV_ReduceMapEntropy");
  EXPECT_EQ(BehaviorNameOf(block), "cover");
  ASSERT_NE(block.Find("condition"), nullptr);
  EXPECT_EQ(block.Find("pwt")->value, "1");
  EXPECT_EQ(block.Find("frontier_weight"), nullptr);
  EXPECT_NO_THROW(BehaviorHost{files});
}

TEST(PlannerPreset, OfTheLawnmowerFliesLanesAndNoSearch) {
  ViewParams params;
  params.planner = "lawnmower";
  const std::string generators = PresetOf(params).generators;
  EXPECT_NE(generators.find("lanes"), std::string::npos);
  EXPECT_EQ(generators.find("beam"), std::string::npos);
}

TEST(PlannerPreset, GivesWayToGeneratorsThatAMissionNames) {
  ViewParams params;
  EXPECT_NE(PresetOf(params).generators, "");
  params.generators = "beam";
  EXPECT_EQ(PresetOf(params).generators, "beam");
}

}  // namespace
}  // namespace limpet
