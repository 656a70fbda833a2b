// SPDX-License-Identifier: MIT
// A helm on a vehicle that says where it is by NAV_X and its kin.
#include "apps/pHelm/stock_nav.hpp"

#include <algorithm>
#include <fstream>
#include <memory>

#include <gtest/gtest.h>

#include "apps/pHelm/helm_app.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/units.hpp"
#include "limpet/helm/registry.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

/// Goes where it looks, at 1 m/s.
class BHV_TestAhead final : public Behavior {
 public:
  struct Params {
    template <class V>
    void Describe(V&) {}
  };
  explicit BHV_TestAhead(const Params&) {}
  [[nodiscard]] MotionBid Move(const VehicleState& state) override {
    MotionBid bid;
    bid.course = Peak{.summit = state.nav.yaw, .flat_half_width = 0.0, .base_half_width = 1.0};
    bid.speed = Peak{.summit = 1.0, .flat_half_width = 0.0, .base_half_width = 1.0};
    bid.depth = Peak{.summit = state.nav.down, .flat_half_width = 0.0, .base_half_width = 5.0};
    return bid;
  }
};
LIMPET_REGISTER_BEHAVIOR(BHV_TestAhead);

/// Has a say on the depth alone, and no goal.
class BHV_TestShallow final : public Behavior {
 public:
  struct Params {
    template <class V>
    void Describe(V&) {}
  };
  explicit BHV_TestShallow(const Params&) {}
  [[nodiscard]] bool IsConstraint() const override { return true; }
  [[nodiscard]] MotionBid Move(const VehicleState&) override {
    MotionBid bid;
    bid.depth = Peak{.summit = 2.0, .flat_half_width = 0.0, .base_half_width = 5.0};
    return bid;
  }
};
LIMPET_REGISTER_BEHAVIOR(BHV_TestShallow);

class StockNavTest : public ::testing::Test {
 protected:
  void Make(const HelmApp::Params& params, const std::string& lines = "") {
    MakeWith("Behavior = BHV_TestAhead\n{\n" + lines + "}\n", params);
  }
  void MakeWith(const std::string& behaviors, const HelmApp::Params& params) {
    std::ofstream(folder_.path() / "mission.bhv") << behaviors;
    AppContext context;
    context.name = "pHelmIvP";
    context.link = &link_;
    context.mission_folder = folder_.path();
    app_ = std::make_unique<HelmApp>(context, params);
  }
  void MakeSurface() {
    HelmApp::Params params;
    params.domain = {"course:0:359:360", "speed:0:4:41"};
    Make(params);
  }
  /// Parked; at points in a stock helm's place.
  void MakeParked(bool is_stand_in) {
    HelmApp::Params params;
    params.domain = {"course:0:359:360", "speed:0:4:41"};
    params.at_points = is_stand_in;
    params.start_in_drive = false;
    link_.published.clear();
    Make(params);
    HearAll(10.0);
  }
  void HearAll(double heading) {
    link_.Send(*app_, topics::kNavX, 3.0);
    link_.Send(*app_, topics::kNavY, 4.0);
    link_.Send(*app_, topics::kNavSpeed, 1.5);
    link_.Send(*app_, topics::kNavHeading, heading);
  }
  void Tick(double seconds = 0.1) {
    link_.time += Seconds(seconds);
    app_->Tick(link_.time);
  }
  [[nodiscard]] bool Said(const std::string& variable) const {
    return std::ranges::any_of(link_.published, [&variable](const MessagePtr& message) {
      return message->name == variable;
    });
  }
  [[nodiscard]] std::string AllStop() const { return *link_.Last(topics::kHelmAllStop); }

  TemporaryFolder folder_;
  TestLink link_;
  std::unique_ptr<HelmApp> app_;
};

TEST_F(StockNavTest, DrivesASurfaceVehicleAndLeavesItsDepthAlone) {
  MakeSurface();
  Tick();
  EXPECT_EQ(AllStop(), "MissingNav");
  HearAll(200.0);
  Tick();
  EXPECT_EQ(AllStop(), "clear");
  EXPECT_NEAR(*link_.Last(topics::kDesiredHeading), 200.0, 1e-9);
  EXPECT_EQ(*link_.Last(topics::kDesiredSpeed), 1.0);
  EXPECT_EQ(link_.Count(topics::kDesiredDepth), 0);
}

TEST_F(StockNavTest, WaitsForTheDepthOfAVehicleThatDives) {
  Make({});
  HearAll(10.0);
  Tick();
  EXPECT_EQ(AllStop(), "MissingNav");
  link_.Send(*app_, topics::kNavDepth, 7.0);
  Tick();
  EXPECT_EQ(*link_.Last(topics::kDesiredDepth), 7.0);
}

TEST_F(StockNavTest, StopsWhenThePositionIsOlderThanTheMissionAllows) {
  MakeSurface();
  HearAll(10.0);
  Tick();
  Tick(4.8);
  EXPECT_EQ(AllStop(), "clear");
  Tick(0.3);
  EXPECT_EQ(AllStop(), "StaleNav");
  EXPECT_EQ(*link_.Last(topics::kDesiredSpeed), 0.0);
  HearAll(10.0);
  Tick();
  EXPECT_EQ(AllStop(), "clear");
}

TEST_F(StockNavTest, HeedsNavStateAloneOnceThereIsOne) {
  MakeSurface();
  HearAll(10.0);
  NavState nav;
  nav.yaw = 1.0;
  link_.Send(*app_, topics::kNavState, nav);
  HearAll(20.0);
  Tick();
  EXPECT_NEAR(*link_.Last(topics::kDesiredHeading), MoosHeadingFromYaw(1.0), 1e-9);
  nav.is_valid = false;
  link_.Send(*app_, topics::kNavState, nav);
  HearAll(20.0);
  Tick();
  EXPECT_EQ(AllStop(), "MissingNav");
}

TEST_F(StockNavTest, StartsParkedWhereTheMissionSaysSoAndIsDrivenByEitherSpelling) {
  HelmApp::Params params;
  params.domain = {"course:0:359:360", "speed:0:4:41"};
  params.start_in_drive = false;
  Make(params);
  HearAll(10.0);
  Tick();
  EXPECT_EQ(*link_.Last(topics::kHelmState), "PARK");
  EXPECT_EQ(AllStop(), "ManualOverride");
  link_.Send(*app_, topics::kManualOverrideMisspelt, false);
  Tick();
  EXPECT_EQ(*link_.Last(topics::kHelmState), "DRIVE");
}

TEST_F(StockNavTest, WhileParkedBehaviorsStandToo) {
  HelmApp::Params params;
  params.domain = {"course:0:359:360", "speed:0:4:41"};
  params.start_in_drive = false;
  Make(params, "duration = 5\n runflag = RAN = yes\n endflag = ENDED = yes\n");
  HearAll(10.0);
  for (int tick = 0; tick < 10; ++tick)
    Tick(1.0);
  EXPECT_FALSE(Said("RAN"));
  EXPECT_FALSE(Said("ENDED")) << "its time runs once it runs";
  link_.Send(*app_, topics::kManualOverride, false);
  HearAll(10.0);
  Tick();
  EXPECT_TRUE(Said("RAN"));
  EXPECT_FALSE(Said("ENDED"));
  link_.Send(*app_, topics::kManualOverride, true);
  for (int tick = 0; tick < 10; ++tick)
    Tick(1.0);
  EXPECT_FALSE(Said("ENDED")) << "no flag is posted by a helm that is parked";
  link_.Send(*app_, topics::kManualOverride, false);
  HearAll(10.0);
  Tick();
  EXPECT_TRUE(Said("ENDED")) << "the time that it was parked counts, as in a stock helm";
}

TEST_F(StockNavTest, AStopWritesAllOfTheDomainWhereItStandsInForAStockHelm) {
  for (const bool is_stand_in : {true, false}) {
    MakeParked(is_stand_in);
    Tick();
    EXPECT_EQ(*link_.Last(topics::kDesiredSpeed), 0.0);
    EXPECT_EQ(Said("DESIRED_HEADING"), is_stand_in) << "a pilot of ours would turn to the north";
  }
}

TEST_F(StockNavTest, AStopIsWrittenAnewInEachIterationWhereItStandsInForAStockHelm) {
  for (const bool is_stand_in : {true, false}) {
    MakeParked(is_stand_in);
    Tick();
    Tick();
    Tick();
    EXPECT_EQ(link_.Count(topics::kDesiredSpeed), is_stand_in ? 3 : 1);
  }
}

TEST_F(StockNavTest, WritesWhatItDecidesUnderThePrefixAndItsStopUnderBothNames) {
  HelmApp::Params params;
  params.domain = {"course:0:359:360", "speed:0:4:41"};
  params.helm_prefix = "PRE_";
  Make(params);
  HearAll(10.0);
  Tick();
  EXPECT_TRUE(Said("PRE_DESIRED_HEADING"));
  EXPECT_TRUE(Said("PRE_DESIRED_SPEED"));
  EXPECT_FALSE(Said("DESIRED_SPEED"));
  link_.published.clear();
  link_.Send(*app_, topics::kManualOverride, true);
  Tick();
  EXPECT_TRUE(Said("PRE_DESIRED_SPEED"));
  EXPECT_EQ(*link_.Last(topics::kDesiredSpeed), 0.0);
}

TEST_F(StockNavTest, StandsStillForConstraintsAloneWhereGoalsAreMandatory) {
  for (const bool are_mandatory : {false, true}) {
    HelmApp::Params params;
    params.domain = {"course:0:359:360:optional", "speed:0:4:41:optional", "depth:0:100:101"};
    params.goals_mandatory = are_mandatory;
    MakeWith("Behavior = BHV_TestShallow\n{\n}\n", params);
    HearAll(10.0);
    link_.Send(*app_, topics::kNavDepth, 1.0);
    Tick();
    Tick();
    EXPECT_EQ(AllStop(), are_mandatory ? "NoGoalBehavior" : "clear");
  }
}

TEST_F(StockNavTest, SaysThatABehaviorBidsOnWhatTheDomainDoesNotHave) {
  HelmApp::Params params;
  params.domain = {"course:0:359:360", "speed:0:4:41"};
  MakeWith("Behavior = BHV_TestShallow\n{\n  name = shallow\n}\n", params);
  HearAll(10.0);
  Tick();
  ASSERT_TRUE(app_->warnings().contains("BID_UNHEARD_shallow"));
  MakeSurface();
  HearAll(10.0);
  Tick();
  EXPECT_TRUE(app_->warnings().empty()) << "who bids on course and speed, too, has a say";
}

TEST_F(StockNavTest, CannotBeParkedWhereTheMissionForbidsIt) {
  HelmApp::Params params;
  params.domain = {"course:0:359:360", "speed:0:4:41"};
  params.allow_park = false;
  Make(params);
  HearAll(10.0);
  link_.Send(*app_, topics::kManualOverride, true);
  Tick();
  EXPECT_EQ(*link_.Last(topics::kHelmState), "DRIVE");
}

TEST(StockNav, TurnsMoosAxesIntoOurs) {
  using Quantity = StockNav::Quantity;
  StockNav nav;
  nav.Hear(Quantity::kX, 3.0, Seconds(1.0));
  nav.Hear(Quantity::kY, 4.0, Seconds(1.0));
  nav.Hear(Quantity::kHeading, 90.0, Seconds(1.0));
  nav.Hear(Quantity::kSpeed, 1.5, Seconds(1.0));
  EXPECT_FALSE(nav.IsComplete(true));
  nav.Hear(Quantity::kAltitude, 9.0, Seconds(0.0));
  const auto state = nav.At(Seconds(2.0), Seconds(1.5), false);
  ASSERT_TRUE(state);
  EXPECT_EQ(state->north, 4.0);
  EXPECT_EQ(state->east, 3.0);
  EXPECT_EQ(state->down, 0.0);
  EXPECT_NEAR(state->yaw, RadiansFromDegrees(90.0), 1e-12);
  EXPECT_EQ(state->u, 1.5);
  EXPECT_FALSE(state->altitude) << "too old";
  EXPECT_FALSE(nav.At(Seconds(2.6), Seconds(1.5), false));
}

}  // namespace
}  // namespace limpet
