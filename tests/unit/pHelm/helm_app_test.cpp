// SPDX-License-Identifier: MIT
// What an operator's displays hear of the helm.
#include "apps/pHelm/helm_app.hpp"

#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/helm/registry.hpp"
#include "limpet/topics/viewer.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Steers north at half a metre per second.
class BHV_TestNorth final : public Behavior {
 public:
  struct Params {
    template <class V>
    void Describe(V&) {}
  };
  explicit BHV_TestNorth(const Params&) {}
  [[nodiscard]] MotionBid Move(const VehicleState&) override {
    MotionBid bid;
    bid.course = Peak{.summit = 0.0, .flat_half_width = 0.0, .base_half_width = 1.0};
    bid.speed = Peak{.summit = 0.5, .flat_half_width = 0.0, .base_half_width = 1.0};
    bid.depth = Peak{.summit = 3.0, .flat_half_width = 0.0, .base_half_width = 1.0};
    return bid;
  }
};
LIMPET_REGISTER_BEHAVIOR(BHV_TestNorth);

constexpr const char* kBehaviors = R"(
set MODE = ACTIVE {
  DEPLOY = true
} INACTIVE

Behavior = BHV_TestNorth
{
  name      = north
  condition = MODE = ACTIVE
}
)";

class HelmAppTest : public ::testing::Test {
 protected:
  HelmAppTest() {
    std::ofstream(folder_.path() / "mission.bhv") << kBehaviors;
    AppContext context;
    context.name = "pHelm";
    context.link = &link_;
    context.mission_folder = folder_.path();
    context.globals = {{"Community", "alpha", {}}};
    context_ = context;
    Make({});
  }
  void Make(const HelmApp::Params& params) { app_ = std::make_unique<HelmApp>(context_, params); }
  void Tick() {
    link_.time += Seconds(0.1);
    app_->Tick(link_.time);
  }
  void Deploy() {
    link_.Send(*app_, topics::kNavState, NavState{});
    link_.Send(*app_, topics::kDeploy, true);
  }
  std::vector<std::string> Posts(const std::string& variable) const {
    std::vector<std::string> values;
    for (const MessagePtr& message : link_.published) {
      if (message->name == variable && std::holds_alternative<std::string>(message->value)) {
        values.push_back(std::get<std::string>(message->value));
      }
    }
    return values;
  }

  TemporaryFolder folder_;
  TestLink link_;
  AppContext context_;
  std::unique_ptr<HelmApp> app_;
};

TEST_F(HelmAppTest, SaysBidsAsPiecesForDisplaysIfAsked) {
  Deploy();
  Tick();
  EXPECT_THAT(Posts("BHV_IPF"), ::testing::IsEmpty()) << "off, unless a block says so";
  HelmApp::Params params;
  params.post_ipf = true;
  Make(params);
  Deploy();
  Tick();
  const std::vector<std::string> posts = Posts("BHV_IPF");
  ASSERT_FALSE(posts.empty());
  EXPECT_THAT(posts.front(), HasSubstr("P,north^1,"));
  EXPECT_THAT(posts.front(), HasSubstr(",1,H,7,1:north,3,"));
  EXPECT_THAT(posts.front(), HasSubstr("D,course;0;359;360:speed;0;1;21:depth;0;100;1001,G,359,20,"
                                       "1000,F,0,"));
  const int pieces = std::stoi(posts.front().substr(posts.front().find("north,3,") + 8));
  EXPECT_EQ(link_.Last(topics::kHelmPiecesFormed), pieces);
}

TEST_F(HelmAppTest, IntroducesItselfOnce) {
  Tick();
  Tick();
  EXPECT_THAT(Posts("IVPHELM_MODESET"), ElementsAre("MODE#---,ACTIVE#---,INACTIVE"));
  EXPECT_THAT(Posts("IVPHELM_DOMAIN"),
              ElementsAre("depth,0,100,1001:speed,0,1,21:course,0,359,360"));
  EXPECT_THAT(Posts("IVPHELM_LIFE_EVENT"),
              ElementsAre("iter=0,time=0.00, bname=north, btype=BHV_TestNorth, event=spawn, "
                          "seed=helm_startup,iter=1"));
  EXPECT_THAT(Posts("IVPHELM_REGISTER"), ElementsAre("DEPLOY", "MODE"));
}

TEST_F(HelmAppTest, SaysAllOfItselfToWhoAsksWithANumberOrAWord) {
  Tick();
  Tick();
  const auto is_whole = [this] {
    return Posts("IVPHELM_SUMMARY").back().find("ivpdomain=") != std::string::npos;
  };
  EXPECT_FALSE(is_whole());
  link_.Send(*app_, topics::kHelmRejournal, 1.0);
  Tick();
  EXPECT_TRUE(is_whole());
  Tick();
  Topic<std::string> as_word;
  as_word.name = topics::kHelmRejournal.name;
  link_.Send(*app_, as_word, std::string("true"));
  Tick();
  EXPECT_TRUE(is_whole());
}

TEST_F(HelmAppTest, SaysItsStateEachIterationAndItsAllStopOnChange) {
  Tick();
  Deploy();
  Tick();
  Tick();
  EXPECT_THAT(Posts("IVPHELM_STATE"), ElementsAre("DRIVE", "DRIVE", "DRIVE"));
  EXPECT_THAT(Posts("IVPHELM_ALLSTOP"), ElementsAre("MissingNav", "clear"));
  link_.Send(*app_, topics::kManualOverride, true);
  Tick();
  EXPECT_EQ(Posts("IVPHELM_STATE").back(), "PARK");
  EXPECT_EQ(Posts("IVPHELM_ALLSTOP").back(), "ManualOverride");
}

TEST_F(HelmAppTest, SteersNoMoreWhileSafetyHoldsTheVehicleOrBringsItUp) {
  Tick();
  Deploy();
  for (const char* action : {"hold", "surface", "abort"}) {
    link_.Send(*app_, topics::kSafetyAction, std::string(action));
    Tick();
    EXPECT_EQ(Posts("IVPHELM_ALLSTOP").back(), std::string("Safety:") + action);
    link_.Send(*app_, topics::kSafetyAction, std::string("return"));
    Tick();
    EXPECT_EQ(Posts("IVPHELM_ALLSTOP").back(), "clear");
  }
}

TEST_F(HelmAppTest, ABehaviorIsIdleThenActive) {
  link_.Send(*app_, topics::kNavState, NavState{});
  Tick();
  EXPECT_THAT(Posts("IVPHELM_BHV_IDLE"), ElementsAre("north"));
  Deploy();
  Tick();
  EXPECT_THAT(Posts("IVPHELM_BHV_ACTIVE"), ElementsAre("north"));
  EXPECT_THAT(Posts("IVPHELM_SUMMARY").back(), HasSubstr("modes=MODE@ACTIVE"));
}

TEST_F(HelmAppTest, SaysWhenTheBandReachesAboveWhatItSees) {
  SurveyArea area{.north_min = -9, .north_max = 9, .east_min = -9, .east_max = 9};
  area.object_height_max = 5.0;  // above the camera
  link_.Send(*app_, topics::kSurveyArea, area);
  EXPECT_TRUE(app_->warnings().contains("BAND_ABOVE_VIEW"));
  area.object_height_max = 3.0;
  link_.Send(*app_, topics::kSurveyArea, area);
  EXPECT_FALSE(app_->warnings().contains("BAND_ABOVE_VIEW"));
}

TEST_F(HelmAppTest, ReportsModeDecisionAndBehaviors) {
  Deploy();
  Tick();
  ReportLines lines;
  app_->Report(lines);
  const std::string text = lines.Text();
  EXPECT_THAT(text, HasSubstr("State:        DRIVE, all-stop clear"));
  EXPECT_THAT(text, HasSubstr("Mode:         MODE@ACTIVE"));
  EXPECT_THAT(text, HasSubstr("Speed:        0.5 m/s"));
  EXPECT_THAT(text, HasSubstr("  north     BHV_TestNorth  100  active"));
}

TEST_F(HelmAppTest, DrawsAreaAndHomeForTheOperator) {
  link_.Send(*app_, topics::kSurveyArea,
             SurveyArea{.north_min = -1, .north_max = 1, .east_min = -2, .east_max = 2});
  link_.Send(*app_, topics::kSurveyHome, HomePoint{.north = 3.0, .east = 4.0});
  EXPECT_THAT(Posts("VIEW_POLYGON").at(0), HasSubstr("pts={-2,-1:2,-1:2,1:-2,1},label=alpha_area"));
  EXPECT_THAT(Posts("VIEW_POINT").at(0), HasSubstr("x=4,y=3,label=alpha_home"));
}

TEST_F(HelmAppTest, SaysThatNothingKeepsOffAnObstacleWithoutAnOutline) {
  Obstacles obstacles{{{.id = 1, .outline = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}}, .top = 0.0},
                       {.id = 2, .outline = {{4.0, 4.0}}, .top = 0.0}}};
  link_.Send(*app_, topics::kMapObstacles, obstacles);
  EXPECT_TRUE(app_->warnings().contains("OBSTACLE_REFUSED"));
  obstacles.obstacles.pop_back();
  link_.Send(*app_, topics::kMapObstacles, obstacles);
  EXPECT_FALSE(app_->warnings().contains("OBSTACLE_REFUSED"));
}

TEST_F(HelmAppTest, RefusesAnAreaThatNoVehicleCanSurveyAndGoesOn) {
  const SurveyArea good{.north_min = -10, .north_max = 10, .east_min = -10, .east_max = 10};
  SurveyArea vast = good, inverted = good, thick = good;
  vast.north_max = 2e6, vast.east_max = 2e6;
  inverted.east_max = -20;
  thick.object_height_max = 1e9;
  for (const SurveyArea& area : {vast, inverted, thick}) {
    link_.Send(*app_, topics::kSurveyArea, area);
    ASSERT_TRUE(app_->warnings().contains("AREA_REFUSED")) << EncodeRecord(area);
    Deploy();
    Tick();
  }
  link_.Send(*app_, topics::kSurveyArea, vast);
  EXPECT_THAT(app_->warnings().at("AREA_REFUSED").text, HasSubstr("north -10 to 2e+06"));
  link_.Send(*app_, topics::kSurveyArea, good);
  EXPECT_FALSE(app_->warnings().contains("AREA_REFUSED"));
}

TEST_F(HelmAppTest, StopsWhenNavigationIsNotValid) {
  Deploy();
  Tick();
  ASSERT_NE(link_.Last(topics::kDesiredSpeed), 0.0);
  NavState lost;
  lost.is_valid = false;
  link_.Send(*app_, topics::kNavState, lost);
  Tick();
  EXPECT_EQ(link_.Last(topics::kDesiredSpeed), 0.0);
  EXPECT_EQ(link_.Last(topics::kHelmAllStop), "MissingNav");
}

TEST_F(HelmAppTest, HoldsOneIterationWithoutADecisionOff) {
  Tick();
  Deploy();
  Tick();
  const int stops = link_.Count(topics::kDesiredTurnRate);
  link_.Send(*app_, topics::kDeploy, false);
  Tick();
  EXPECT_EQ(Posts("IVPHELM_ALLSTOP").back(), "NothingToDo");
  EXPECT_EQ(link_.Last(topics::kDesiredSpeed), 0.5) << "another behavior may take over";
  link_.Send(*app_, topics::kDeploy, true);
  Tick();
  EXPECT_EQ(Posts("IVPHELM_ALLSTOP").back(), "clear");
  EXPECT_EQ(link_.Last(topics::kDesiredSpeed), 0.5);
  link_.Send(*app_, topics::kDeploy, false);
  Tick();
  Tick();
  EXPECT_EQ(link_.Last(topics::kDesiredSpeed), 0.0);
  Tick();
  EXPECT_EQ(link_.Count(topics::kDesiredTurnRate), stops + 2) << "told once";
}

TEST_F(HelmAppTest, SaysThatItIsMalconfiguredBeforeItEnds) {
  std::ofstream(folder_.path() / "mission.bhv") << "Behavior = BHV_TestNorth\n{\n  nord = 1\n}\n";
  EXPECT_THROW(Make({}), ConfigError);
  EXPECT_THAT(Posts("IVPHELM_STATE"), ElementsAre("MALCONFIG"));
}

TEST_F(HelmAppTest, AsksTheLoggerForItsBehaviorFilesAndSaysThatItIsBack) {
  context_.runs_live = true;
  context_.is_restarted = true;
  Make({});
  Deploy();
  Tick();
  Tick();
  EXPECT_THAT(Posts("PLOGGER_CMD"), ElementsAre("COPY_FILE_REQUEST = mission.bhv"));
  EXPECT_THAT(Posts("IVPHELM_RESTARTED"), ElementsAre("true"));
}

TEST_F(HelmAppTest, NamesEachVariableOfItsStateOnce) {
  std::ofstream(folder_.path() / "mission.bhv")
      << "Behavior = BHV_TestNorth\n{\n  name = a\n  condition = RETURN = false\n"
         "  endflag = RETURN = true\n}\n";
  Make({});
  Tick();
  EXPECT_EQ(Posts("IVPHELM_STATEVARS").back(), "RETURN");
}

TEST_F(HelmAppTest, NamesTheVariablesOfABehaviorThatIsMadeUnderWay) {
  std::ofstream(folder_.path() / "mission.bhv")
      << "Behavior = BHV_TestNorth\n{\n  name = a\n}\n"
         "Behavior = BHV_TestNorth\n{\n  name = b_\n  templating = spawn\n  updates = MORE\n"
         "  endflag = FOUND = true\n}\n";
  Make({});
  Deploy();
  Tick();
  const std::size_t before = Posts("IVPHELM_STATEVARS").size();
  Topic<std::string> more;
  more.name = "MORE";
  link_.Send(*app_, more, std::string("name = one # condition = GO = true"));
  Tick();
  Tick();
  ASSERT_GT(Posts("IVPHELM_STATEVARS").size(), before);
  EXPECT_THAT(Posts("IVPHELM_STATEVARS").back(), HasSubstr("GO"));
}

}  // namespace
}  // namespace limpet
