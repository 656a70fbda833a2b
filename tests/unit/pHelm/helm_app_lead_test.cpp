// SPDX-License-Identifier: MIT
// What a helm that leads another one leaves to the other.
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/pHelm/helm_app.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/topics/viewer.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;

/// Wants to go east at half a metre per second, 2 m deep.
class BHV_TestEast final : public Behavior {
 public:
  struct Params {
    template <class V>
    void Describe(V&) {}
  };
  explicit BHV_TestEast(const Params&) {}
  [[nodiscard]] MotionBid Move(const VehicleState&) override {
    MotionBid bid;
    bid.course = Peak{.summit = 0.5 * std::numbers::pi};
    bid.speed = Peak{.summit = 0.5};
    bid.depth = Peak{.summit = 2.0};
    return bid;
  }
};
LIMPET_REGISTER_BEHAVIOR(BHV_TestEast);

TEST(HelmThatLeads, LeavesDesiredsModesAndTheHelmsOwnWordsToTheOther) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "mission.bhv")
      << "set MODE = ON {\n  DEPLOY = true\n} OFF\nBehavior = BHV_TestEast\n{\n  name = east\n}\n";
  TestLink link;
  AppContext context;
  context.name = "pHelm";
  context.link = &link;
  context.mission_folder = folder.path();
  HelmApp app(context, [] {
    HelmApp::Params params;
    params.lead = "WAY", params.lead_depth = "DEPTH";
    params.lead_course = "COURSE", params.lead_speed = "SPEED";
    return params;
  }());
  link.Send(app, topics::kNavState, NavState{});
  link.Send(app, topics::kDeploy, true);
  for (int i = 0; i < 3; ++i) {
    link.time += Seconds(0.1);
    app.Tick(link.time);
  }
  std::vector<std::string> posts;
  for (const MessagePtr& message : link.published) {
    if (message->name.ends_with("_WARNINGS")) continue;
    posts.push_back(message->name);
  }
  EXPECT_THAT(posts, ElementsAre("BHV_SETTINGS", "DEPTH", "COURSE", "SPEED", "HELM_LEAD"))
      << "and what its own behavior is set to";
  link.time += Seconds(11.0);
  link.Send(app, topics::kNavState, NavState{});
  app.Tick(link.time);
  EXPECT_EQ(app.warnings().at("LED_HELM_DEAF").text,
            "nobody answers to COURSE; nobody answers to DEPTH; nobody answers to SPEED");
  for (const char* variable : {"COURSE", "DEPTH", "SPEED"}) {
    link.Send(app, topics::kHelmUpdateResult,
              std::string("bhv=any,var=") + variable + ",time=1.00,result=success,val=x");
  }
  link.Send(app, topics::kManualOverride, true);
  link.time += Seconds(0.1);
  app.Tick(link.time);
  EXPECT_FALSE(app.warnings().contains("LED_HELM_DEAF"));
  EXPECT_EQ(link.Last(topics::kHelmLead), "none");
}

}  // namespace
}  // namespace limpet
