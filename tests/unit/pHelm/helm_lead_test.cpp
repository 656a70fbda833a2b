// SPDX-License-Identifier: MIT
// What a helm that leads another one says, and what it leaves to the other.
#include "apps/pHelm/helm_lead.hpp"

#include <fstream>
#include <numbers>

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
using ::testing::IsEmpty;
using ::testing::StartsWith;

class LeadingHelm : public ::testing::Test {
 protected:
  LeadingHelm() {
    motion_.course = 0.5 * std::numbers::pi;
    motion_.speed = 0.5;
    motion_.depth = 3.0;
  }
  [[nodiscard]] std::vector<std::string> Said() { return std::exchange(said_, {}); }

  std::vector<std::string> said_;
  HelmLead lead_{{.waypoints = "WAY", .depth = "DEPTH", .course = "COURSE", .speed = "SPEED"},
                 [this](const std::string& variable, const Value& value) {
                   said_.push_back(variable + ": " + std::get<std::string>(value));
                 }};
  MotionDecision motion_;
  DubinsPath path_{{.north = 1.0, .east = 2.0, .yaw = 0.0}, {{.curvature = 0.0, .length = 10.0}}};
};

TEST_F(LeadingHelm, TellsDepthThenWayThenThatThereIsOne) {
  lead_.Follow(path_);
  lead_.Steer(true, motion_);
  EXPECT_THAT(Said(), ElementsAre("DEPTH: depth = 3", "WAY: points = 2,1:2,11 # speed = 0.5",
                                  "HELM_LEAD: way"));
}

TEST_F(LeadingHelm, TellsWhatIsNewAlone) {
  lead_.Follow(path_);
  lead_.Steer(true, motion_);
  static_cast<void>(Said());
  lead_.Steer(true, motion_);
  EXPECT_THAT(Said(), IsEmpty());
  motion_.speed = 0.3;
  motion_.depth = 3.2;
  lead_.Steer(true, motion_);
  EXPECT_THAT(Said(), ElementsAre("DEPTH: depth = 3.2", "WAY: speed = 0.3"));
}

TEST_F(LeadingHelm, WithoutAWayTellsCourseAndSpeed) {
  lead_.Steer(false, motion_);
  EXPECT_THAT(Said(), ElementsAre("DEPTH: depth = 3", "COURSE: heading = 90", "SPEED: speed = 0.5",
                                  "HELM_LEAD: course"));
  motion_.speed.reset();
  lead_.Steer(false, motion_);
  EXPECT_THAT(Said(), ElementsAre("HELM_LEAD: hold"));
}

TEST_F(LeadingHelm, BringsTheVehicleUpWhenAllIsToStop) {
  lead_.Follow(path_);
  lead_.Steer(true, motion_);
  static_cast<void>(Said());
  lead_.Stop();
  EXPECT_THAT(Said(), ElementsAre("HELM_LEAD: none", "DEPTH: depth = 0"));
  lead_.Steer(true, motion_);
  EXPECT_THAT(Said(), ElementsAre("DEPTH: depth = 3", "HELM_LEAD: way"))
      << "the other helm has the way still";
}

TEST(WaypointsText, CutsTurnsByATenthOfAMetreAtMost) {
  const double radius = 3.0;
  const DubinsPath turn({.north = 0.0, .east = 0.0, .yaw = 0.0},
                        {{.curvature = 1.0 / radius, .length = std::numbers::pi * radius}});
  const std::vector<MapPoint> points = MapPointsOf(turn, 0.1);
  EXPECT_THAT(WaypointsText(turn), StartsWith("0,0:"));
  ASSERT_GT(points.size(), 4U);
  EXPECT_LT(points.size(), 12U);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double x = 0.5 * (points[i - 1].x + points[i].x) - radius;
    const double y = 0.5 * (points[i - 1].y + points[i].y);
    EXPECT_NEAR(std::hypot(x, y), radius, 0.1);
  }
}

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
