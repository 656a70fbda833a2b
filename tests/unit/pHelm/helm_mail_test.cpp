// SPDX-License-Identifier: MIT
// Which mail the helm hears, and what it says as it begins, by a stock helm's keys.
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/pHelm/helm_app.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/topics/viewer.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

/// Asks for obstacles as the helm begins; goes nowhere.
class BHV_TestAsks final : public Behavior {
 public:
  struct Params {
    template <class V>
    void Describe(V&) {}
  };
  explicit BHV_TestAsks(const Params&) {}
  [[nodiscard]] std::optional<BehaviorPost> Request(const std::string& updates) const override {
    return BehaviorPost{.variable = "OBM_ALERT_REQUEST", .value = "update_var=" + updates};
  }
};
LIMPET_REGISTER_BEHAVIOR(BHV_TestAsks);

constexpr const char* kAsking = R"(
initialize DEPLOY = false
set MODE = ACTIVE {
  DEPLOY = true
} INACTIVE
Behavior = BHV_TestAsks
{
  name       = asks
  templating = spawn
  updates    = ALERT
  condition  = DEPLOY = true
}
)";

class HelmMailTest : public ::testing::Test {
 protected:
  void Make(const HelmApp::Params& params, bool runs_live = true) {
    std::ofstream(folder_.path() / "mission.bhv") << kAsking;
    AppContext context;
    context.name = "pHelmIvP";
    context.link = &link_;
    context.runs_live = runs_live;
    context.mission_folder = folder_.path();
    context.globals = {{"Community", "alpha", {}}};
    app_ = std::make_unique<HelmApp>(context, params);
  }
  void Tick() {
    link_.time += Seconds(0.1);
    app_->Tick(link_.time);
  }
  void Say(const std::string& variable, const std::string& text, double seconds_ago = 0.0) {
    Topic<std::string> topic;
    topic.name = variable;
    link_.SendStamped(*app_, topic, text, link_.time - Seconds(seconds_ago));
  }
  [[nodiscard]] std::string Mode() const {
    Topic<std::string> mode;
    mode.name = "MODE";
    return link_.Last(mode).value_or("");
  }
  [[nodiscard]] std::vector<std::string> Published() const {
    std::vector<std::string> names;
    for (const MessagePtr& message : link_.published) {
      names.push_back(message->name);
    }
    return names;
  }

  TemporaryFolder folder_;
  TestLink link_;
  std::unique_ptr<HelmApp> app_;
};

TEST_F(HelmMailTest, WhatBehaviorsAskForWaitsForTheAppsThatTheBlockNames) {
  HelmApp::Params params;
  params.hold_on_app = {"pObstacleMgr, pTaskManager"};
  Make(params);
  Tick();
  EXPECT_THAT(Published(), Contains("DEPLOY")) << "what the mission begins with does not wait";
  Say("DB_CLIENTS", "pNav,pObstacleMgr,pHelmIvP");
  Tick();
  EXPECT_THAT(Published(), Not(Contains("OBM_ALERT_REQUEST")));
  EXPECT_THAT(app_->warnings().at("APPS_AWAITED").text, HasSubstr("pTaskManager"));
  Say("DB_CLIENTS", "pNav,pTaskManager,pHelmIvP");
  Tick();
  Tick();
  EXPECT_THAT(Published(), Contains("OBM_ALERT_REQUEST").Times(1));
  EXPECT_FALSE(app_->warnings().contains("APPS_AWAITED"));
}

TEST_F(HelmMailTest, WhatAnUpdateMakesABehaviorAskForIsHeard) {
  std::ofstream(folder_.path() / "own.bhv")
      << "Behavior = BHV_TestAsks\n{\n name = t\n updates = TIMER_UPDATE\n}\n";
  HelmApp::Params params;
  params.behaviors = {"own.bhv"};
  Make(params);
  Tick();
  EXPECT_THAT(link_.subscriptions, Not(Contains("ZZ")));
  Say("TIMER_UPDATE", "condition = ZZ = true");
  Tick();
  EXPECT_THAT(link_.subscriptions, Contains("ZZ"));
}

TEST_F(HelmMailTest, NobodyIsWaitedForInAnEmbeddedRun) {
  HelmApp::Params params;
  params.hold_on_app = {"pObstacleMgr"};
  Make(params, false);
  Tick();
  EXPECT_THAT(Published(), Contains("OBM_ALERT_REQUEST"));
}

TEST_F(HelmMailTest, MailOfAnotherTimeIsLeftOutAndSaid) {
  HelmApp::Params params;
  params.ok_skew = Seconds(60.0);
  Make(params);
  link_.Send(*app_, topics::kNavState, NavState{});
  link_.time += Seconds(300.0);
  Say("DEPLOY", "true", 100.0);
  Tick();
  EXPECT_EQ(Mode(), "INACTIVE");
  EXPECT_THAT(link_.Last(topics::kHelmSkew).value(), HasSubstr("DEPLOY of 100.0 s ago"));
  EXPECT_TRUE(app_->warnings().contains("MAIL_SKEWED"));
  Say("DEPLOY", "true", 1.0);
  Tick();
  EXPECT_EQ(Mode(), "ACTIVE");
  EXPECT_FALSE(app_->warnings().contains("MAIL_SKEWED"));
}

TEST_F(HelmMailTest, AnySkewIsRightUnlessTheBlockSaysWhichIs) {
  Make({});
  link_.Send(*app_, topics::kNavState, NavState{});
  link_.time += Seconds(300.0);
  Say("DEPLOY", "true", 100.0);
  Tick();
  EXPECT_EQ(Mode(), "ACTIVE");
}

TEST_F(HelmMailTest, WhoTakesTheVehicleOverIsHeardWhateverTheClocksSay) {
  HelmApp::Params params;
  params.ok_skew = Seconds(60.0);
  Make(params);
  link_.time += Seconds(300.0);
  Say("MOOS_MANUAL_OVERRIDE", "true", 100.0);
  Tick();
  EXPECT_EQ(link_.Last(topics::kHelmState), "PARK");
}

TEST_F(HelmMailTest, IsParkedByTheOtherVariableToo) {
  HelmApp::Params params;
  params.other_override_var = "HAND_ON";
  Make(params);
  Say("HAND_ON", "TRUE");
  Tick();
  EXPECT_EQ(link_.Last(topics::kHelmState), "PARK");
  Say("HAND_ON", "false");
  Tick();
  EXPECT_EQ(link_.Last(topics::kHelmState), "DRIVE");
}

TEST_F(HelmMailTest, ParksItselfWithTheFirstStopWhereItIsTo) {
  HelmApp::Params params;
  params.park_on_allstop = true;
  Make(params);
  link_.Send(*app_, topics::kNavState, NavState{});
  Tick();
  EXPECT_EQ(link_.Last(topics::kHelmState), "PARK") << "there is nothing to do";
  params.allow_park = false;
  Make(params);
  link_.Send(*app_, topics::kNavState, NavState{});
  Tick();
  EXPECT_EQ(link_.Last(topics::kHelmState), "DRIVE");
}

}  // namespace
}  // namespace limpet
