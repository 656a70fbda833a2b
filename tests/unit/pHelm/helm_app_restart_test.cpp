// SPDX-License-Identifier: MIT
// RESTART_HELM: a .bhv file that was edited is taken up without a new launch.
#include <fstream>
#include <memory>
#include <stdexcept>
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

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Steers north, as fast as its file says, and wipes its mark off viewers as it ceases, if it can.
class BHV_TestPace final : public Behavior {
 public:
  struct Params {
    double speed = 0.5;
    bool throws_at_end = false;
    template <class V>
    void Describe(V& visit) {
      visit("speed", speed, "Its speed", InRange(0.0, 1.0));
      visit("throws_at_end", throws_at_end, "Throws where it should wipe off its mark");
    }
  };
  explicit BHV_TestPace(const Params& params) : params_(params) {}
  [[nodiscard]] MotionBid Move(const VehicleState&) override {
    const auto at = [](double wanted) {
      return Peak{.summit = wanted, .flat_half_width = 0.0, .base_half_width = 1.0};
    };
    MotionBid bid;
    bid.course = at(0.0);
    bid.speed = at(params_.speed);
    bid.depth = at(3.0);
    return bid;
  }
  [[nodiscard]] std::vector<BehaviorAct> Stop(const VehicleState&) override {
    if (params_.throws_at_end) throw std::runtime_error("its mark is lost");
    return {BehaviorPost{.variable = "VIEW_MARKER", .value = "label=pace,active=false"}};
  }

 private:
  Params params_;
};
LIMPET_REGISTER_BEHAVIOR(BHV_TestPace);

std::string Block(const std::string& name, const std::string& line) {
  return "Behavior = BHV_TestPace\n{\n  name = " + name + "\n  condition = DEPLOY = true\n  " +
         line + "\n}\n";
}

class HelmRestart : public ::testing::Test {
 protected:
  HelmRestart() {
    Write("0.5");
    context_.name = "pHelm";
    context_.link = &link_;
    context_.mission_folder = folder_.path();
    context_.globals = {{"Community", "alpha", {}}};
    HelmParams params;
    params.helm_alias = "north_wind";
    app_ = std::make_unique<HelmApp>(context_, params);
    link_.Send(*app_, topics::kNavState, NavState{});
    link_.Send(*app_, topics::kDeploy, true);
    Tick();
    Tick();
  }
  void Write(const std::string& speed, const std::string& more = "") {
    std::ofstream(folder_.path() / "mission.bhv")
        << "initialize DEPLOY = false\n" + Block("pace", "speed = " + speed) + more;
  }
  void Tick() {
    link_.time += Seconds(0.1);
    app_->Tick(link_.time);
  }
  void Restart(const std::string& type) { link_.Send(*app_, topics::kHelmRestart, type); }
  [[nodiscard]] std::vector<std::string> Posts(const std::string& variable) const {
    std::vector<std::string> values;
    for (const MessagePtr& message : link_.published) {
      if (message->name != variable) continue;
      const auto* text = std::get_if<std::string>(&message->value);
      if (text != nullptr) values.push_back(*text);
    }
    return values;
  }

  TemporaryFolder folder_;
  TestLink link_;
  AppContext context_;
  std::unique_ptr<HelmApp> app_;
};

TEST_F(HelmRestart, TakesUpFilesThatWereEditedAndGoesOnWithWhatItHasHeard) {
  EXPECT_EQ(link_.Last(topics::kDesiredSpeed), 0.5);
  Write("0.8", Block("other", "speed = 0.8"));
  link_.published.clear();
  Restart("type1");
  Tick();
  EXPECT_EQ(link_.Last(topics::kDesiredSpeed), 0.8) << "DEPLOY is still true";
  EXPECT_THAT(Posts("DEPLOY"), IsEmpty());
  EXPECT_THAT(Posts("IVPHELM_RESTARTED"), ElementsAre("true"));
  EXPECT_EQ(link_.Last(topics::kHelmBehaviorCount), 2);
  EXPECT_THAT(Posts("IVPHELM_LIFE_EVENT"), Contains(HasSubstr("bname=other")));
  EXPECT_THAT(Posts("IVPHELM_SUMMARY"), Contains(HasSubstr("active_bhvs=pace$")));
  Tick();
  EXPECT_THAT(Posts("IVPHELM_RESTARTED"), ElementsAre("true")) << "told once";
}

TEST_F(HelmRestart, WipesOffWhatTheFormerBehaviorsHaveDrawn) {
  Restart("type1");
  EXPECT_THAT(Posts("VIEW_MARKER"), ElementsAre("label=pace,active=false"));
}

TEST_F(HelmRestart, SaysWhoOfTheFormerBehaviorsFailedAsItCeased) {
  Write("0.5", Block("other", "throws_at_end = true"));
  Restart("type1");
  Tick();
  Write("0.8");
  Restart("type1");
  Tick();
  EXPECT_EQ(link_.Last(topics::kDesiredSpeed), 0.8);
  EXPECT_EQ(link_.Last(topics::kBehaviorError), "other: it has thrown: its mark is lost");
}

TEST_F(HelmRestart, PostsWhatEditedFilesAddForVariablesThatNobodyHasWritten) {
  Write("0.8", "initialize_ RETURN = false\ninitialize_ DEPLOY = false\n");
  link_.published.clear();
  Restart("type1");
  EXPECT_THAT(Posts("RETURN"), ElementsAre("false"));
  EXPECT_THAT(Posts("DEPLOY"), IsEmpty()) << "it has been heard";
}

TEST_F(HelmRestart, PostsInitialValuesAgainIfAskedTo) {
  link_.published.clear();
  Restart("type2");
  EXPECT_THAT(Posts("DEPLOY"), ElementsAre("false"));
}

TEST_F(HelmRestart, KeepsItsBehaviorsWhereTheFilesMakeNone) {
  Write("0.8", Block("other", "sped = 0.8"));
  Restart("type1");
  Tick();
  EXPECT_EQ(link_.Last(topics::kDesiredSpeed), 0.5);
  ASSERT_TRUE(app_->warnings().contains("RESTART_REFUSED"));
  EXPECT_THAT(app_->warnings().at("RESTART_REFUSED").text, HasSubstr("sped"));
  EXPECT_THAT(Posts("IVPHELM_RESTARTED"), IsEmpty());
  Write("0.8");
  Restart("type1");
  Tick();
  EXPECT_FALSE(app_->warnings().contains("RESTART_REFUSED"));
  EXPECT_EQ(link_.Last(topics::kDesiredSpeed), 0.8);
}

TEST_F(HelmRestart, RefusesOtherWordsAndSaysSo) {
  Write("0.8");
  Restart("TRUE");
  Tick();
  EXPECT_EQ(link_.Last(topics::kDesiredSpeed), 0.5);
  EXPECT_TRUE(app_->warnings().contains("RESTART_REFUSED"));
}

TEST_F(HelmRestart, BeforeItsFirstIterationBeginsWithTheNewFiles) {
  app_ = std::make_unique<HelmApp>(context_, HelmParams());
  Write("0.8", Block("other", "speed = 0.8"));
  link_.published.clear();
  Restart("type1");
  Tick();
  EXPECT_EQ(link_.Last(topics::kHelmBehaviorCount), 2);
  EXPECT_THAT(Posts("DEPLOY"), ElementsAre("false")) << "as any helm that begins";
  EXPECT_EQ(Posts("IVPHELM_DOMAIN").size(), 1U);
  EXPECT_THAT(Posts("IVPHELM_RESTARTED"), IsEmpty());
}

TEST_F(HelmRestart, AProcessThatWasReplacedLeavesAnOldWordAlone) {
  Write("0.8");
  link_.SendStamped(*app_, topics::kHelmRestart, std::string("type2"), link_.time - Seconds(60.0));
  Tick();
  EXPECT_EQ(link_.Last(topics::kDesiredSpeed), 0.5);
}

TEST_F(HelmRestart, SaysWhatTheHelmIsCalled) {
  EXPECT_THAT(Posts("IVPHELM_ALIAS"), ElementsAre("north_wind"));
}

}  // namespace
}  // namespace limpet
