// SPDX-License-Identifier: MIT
#include "apps/pPilot/pilot_app.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

AppContext ContextFor(TestLink& link) {
  AppContext context;
  context.globals = {{"VehicleFile", "feelhippo.yaml", {}}};
  context.name = "pPilot";
  context.link = &link;
  return context;
}

class PilotAppTest : public testing::Test {
 protected:
  void SendNav() {
    NavState nav;
    nav.down = 3.0;
    link_.Send(app_, topics::kNavState, nav);
  }
  void SendWishes() {
    link_.Send(app_, topics::kDesiredHeading, 0.0);
    link_.Send(app_, topics::kDesiredSpeed, 0.5);
    link_.Send(app_, topics::kDesiredDepth, 3.0);
  }
  void SendWishesButDepth() {
    link_.Send(app_, topics::kDesiredHeading, 0.0);
    link_.Send(app_, topics::kDesiredSpeed, 0.5);
  }
  [[nodiscard]] std::size_t CountOfCommands() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        link_.published, [](const auto& m) { return m->name == topics::kThrusterCommand.name; }));
  }
  [[nodiscard]] std::vector<double> Thrusts() const {
    const ThrusterCommand c = *link_.Last(topics::kThrusterCommand);
    return {c.t1, c.t2, c.t3, c.t4, c.t5, c.t6};
  }
  [[nodiscard]] bool IsAtRest() const {
    return std::ranges::all_of(Thrusts(), [](double t) { return t == 0.0; });
  }
  [[nodiscard]] bool AllFinite() const {
    return link_.Last(topics::kThrusterCommand).has_value() &&
           std::ranges::all_of(Thrusts(), [](double t) { return std::isfinite(t); });
  }
  void Tick(int times = 1) {
    for (int i = 0; i < times; ++i) {
      app_.Tick(link_.time);
      link_.time += Seconds(0.1);
    }
  }
  /// Sum of the four horizontal thrusters: surge.
  double Surge() const {
    const ThrusterCommand c = *link_.Last(topics::kThrusterCommand);
    return c.t1 + c.t2 + c.t3 + c.t4;
  }
  [[nodiscard]] bool HasWarning(const std::string& id) const {
    return app_.warnings().contains(id);
  }

  TestLink link_;
  PilotApp app_{ContextFor(link_), {}};
};

TEST_F(PilotAppTest, GoesOnlyUpwardsWhenSafetyAsksForTheSurfaceWhateverTheHelmWants) {
  for (const char* action : {"surface", "abort"}) {
    link_.Send(app_, topics::kSafetyAction, std::string(action));
    for (int i = 0; i < 30; ++i) {
      SendNav();
      SendWishes();
      Tick();
    }
    const ThrusterCommand c = *link_.Last(topics::kThrusterCommand);
    EXPECT_LT(c.t5 + c.t6, -0.01) << action;
    EXPECT_NEAR(Surge(), 0.0, 1e-9) << action;
  }
}

TEST_F(PilotAppTest, GoesUpWithoutAHelmAndRestsWithoutNavigation) {
  link_.Send(app_, topics::kSafetyAction, std::string("surface"));
  for (int i = 0; i < 10; ++i) {
    SendNav();
    Tick();
  }
  EXPECT_FALSE(IsAtRest());
  Tick(12);
  EXPECT_TRUE(IsAtRest());
}

TEST_F(PilotAppTest, IsAtRestOnceItIsUp) {
  link_.Send(app_, topics::kSafetyAction, std::string("abort"));
  link_.Send(app_, topics::kNavState, NavState{});
  Tick();
  EXPECT_TRUE(IsAtRest());
}

TEST_F(PilotAppTest, HoldsItsDepthWithoutWayOnUntilSafetyLetsGo) {
  SendNav();
  SendWishes();
  Tick(3);
  ASSERT_GT(Surge(), 0.1);
  link_.Send(app_, topics::kSafetyAction, std::string("hold"));
  for (int i = 0; i < 20; ++i) {
    SendNav();  // and no word of the helm
    Tick();
  }
  EXPECT_NEAR(Surge(), 0.0, 0.05);
  const ThrusterCommand c = *link_.Last(topics::kThrusterCommand);
  EXPECT_GT(c.t5 + c.t6, 0.0);  // against its buoyancy
  EXPECT_FALSE(HasWarning("DESIRED_STALE"));
  link_.Send(app_, topics::kSafetyAction, std::string("none"));
  SendWishes();
  Tick(5);
  EXPECT_GT(Surge(), 0.1);
}

TEST_F(PilotAppTest, GoesSlowlyWhenSafetyAsksForIt) {
  link_.Send(app_, topics::kSafetyAction, std::string("degrade"));
  NavState nav;
  nav.down = 3.0;
  nav.u = 0.4;  // wanted are 0.5 m/s
  for (int i = 0; i < 10; ++i) {
    link_.Send(app_, topics::kNavState, nav);
    SendWishes();
    Tick();
  }
  EXPECT_LT(Surge(), 0.0);
  link_.Send(app_, topics::kSafetyAction, std::string("warn"));
  for (int i = 0; i < 30; ++i) {
    link_.Send(app_, topics::kNavState, nav);
    SendWishes();
    Tick();
  }
  EXPECT_GT(Surge(), 0.0);
}

TEST_F(PilotAppTest, RefusesASafetyActionThatIsNone) {
  link_.Send(app_, topics::kSafetyAction, std::string("abort"));
  link_.Send(app_, topics::kSafetyAction, std::string("relax"));
  SendNav();
  SendWishes();
  Tick(20);
  EXPECT_NEAR(Surge(), 0.0, 1e-9);
  EXPECT_TRUE(HasWarning("REFUSED_SAFETY_ACTION"));
  link_.Send(app_, topics::kSafetyAction, std::string("none"));
  EXPECT_FALSE(HasWarning("REFUSED_SAFETY_ACTION"));
}

TEST_F(PilotAppTest, SaysZeroAtEveryTickBeforeTheHelmHasWishes) {
  SendNav();
  Tick(20);
  EXPECT_EQ(CountOfCommands(), 20U);
  EXPECT_TRUE(IsAtRest());
  EXPECT_TRUE(app_.warnings().empty());
}

TEST_F(PilotAppTest, PushesForwardWhenAskedForSpeed) {
  SendNav(), SendWishes();
  Tick(10);
  EXPECT_GT(Surge(), 0.2);
}

TEST_F(PilotAppTest, StopsAllThrustersASecondAfterTheHelmFellSilent) {
  SendNav(), SendWishes();
  for (int i = 0; i < 10; ++i)
    SendNav(), Tick();
  EXPECT_FALSE(IsAtRest());
  for (int i = 0; i < 2; ++i)
    SendNav(), Tick();
  EXPECT_TRUE(IsAtRest());
  EXPECT_TRUE(HasWarning("DESIRED_STALE"));
  const std::size_t count = CountOfCommands();
  for (int i = 0; i < 10; ++i)
    SendNav(), Tick();
  EXPECT_EQ(CountOfCommands(), count + 10) << "the driver must see that the pilot lives";
}

TEST_F(PilotAppTest, OneWishThatFallsSilentIsEnough) {
  SendNav(), SendWishes();
  for (int i = 0; i < 12; ++i) {
    SendNav();
    link_.Send(app_, topics::kDesiredHeading, 0.0);
    link_.Send(app_, topics::kDesiredSpeed, 0.5);
    Tick();
  }
  EXPECT_TRUE(IsAtRest());
}

TEST_F(PilotAppTest, RestsWithoutAWarningWhenTheHelmHasStoppedAll) {
  SendNav(), SendWishes();
  Tick(5);
  link_.Send(app_, topics::kHelmAllStop, std::string("NothingToDo"));
  for (int i = 0; i < 12; ++i)
    SendNav(), Tick();
  EXPECT_TRUE(IsAtRest());
  EXPECT_TRUE(app_.warnings().empty());
}

TEST_F(PilotAppTest, StopsAllThrustersASecondAfterNavigationFellSilent) {
  SendNav(), SendWishes();
  for (int i = 0; i < 10; ++i)
    SendWishes(), Tick();
  EXPECT_FALSE(IsAtRest());
  for (int i = 0; i < 2; ++i)
    SendWishes(), Tick();
  EXPECT_TRUE(IsAtRest());
  EXPECT_TRUE(HasWarning("NAV_STALE"));
}

TEST_F(PilotAppTest, FliesOnWithoutAWarningWhenHelmAndNavigationAreBack) {
  SendNav(), SendWishes();
  Tick(15);
  SendNav(), Tick();
  EXPECT_TRUE(HasWarning("DESIRED_STALE"));
  SendWishes(), Tick(15);
  SendWishes(), Tick();
  EXPECT_TRUE(HasWarning("NAV_STALE"));
  SendNav(), SendWishes(), Tick();
  EXPECT_TRUE(app_.warnings().empty());
  EXPECT_FALSE(IsAtRest());
}

TEST_F(PilotAppTest, WarnsOfControlLawsThatGiveNoNumberUntilTheyDo) {
  PilotApp::Params params;
  params.depth_gain = 1.7e308;  // a small error makes it overflow
  PilotApp app(ContextFor(link_), params);
  const auto fly = [&] {
    link_.Send(app, topics::kNavState, NavState{.down = 3.0, .altitude = {}});
    link_.Send(app, topics::kDesiredHeading, 0.0);
    link_.Send(app, topics::kDesiredSpeed, 0.5);
    link_.Send(app, topics::kDesiredDepth, 10.0);
    app.Tick(link_.time);
    link_.time += Seconds(0.1);
  };
  for (int i = 0; i < 100 && app.warnings().empty(); ++i) {
    fly();
  }
  ASSERT_TRUE(app.warnings().contains("COMMAND_NOT_FINITE"));
  EXPECT_TRUE(IsAtRest());
  fly();  // the laws begin anew, without an error
  EXPECT_FALSE(app.warnings().contains("COMMAND_NOT_FINITE"));
}

TEST_F(PilotAppTest, CountsAgesByItsOwnClock) {
  NavState nav;
  nav.down = 3.0;
  for (int i = 0; i < 20; ++i) {  // a sender whose clock is an hour ahead, and then silence
    const Seconds here = link_.time;
    link_.time += Seconds(3600.0);
    const Message ahead{.name = "NAV_STATE",
                        .value = TopicCodec<NavState>::Encode(nav),
                        .time = link_.time,
                        .source = "pNav",
                        .source_aux = "",
                        .community = ""};
    link_.time = here;
    if (i < 5) app_.Deliver(std::make_shared<const Message>(ahead));
    SendWishes(), Tick();
  }
  EXPECT_TRUE(IsAtRest());
}

TEST_F(PilotAppTest, RefusesAndCountsWishesThatNoHelmMeans) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  for (const auto& topic : {topics::kDesiredHeading, topics::kDesiredSpeed, topics::kDesiredDepth,
                            topics::kDesiredTurnRate}) {
    for (const double bad : {nan, infinite, -infinite, 1e12}) {
      SendNav(), SendWishes();
      link_.Send(app_, topic, bad);
      Tick();
      EXPECT_TRUE(AllFinite()) << topic.name << " " << bad;
      EXPECT_TRUE(HasWarning("REFUSED_" + topic.name));
    }
    link_.Send(app_, topic, 0.1);
    EXPECT_FALSE(HasWarning("REFUSED_" + topic.name));
  }
  ReportLines lines;
  app_.Report(lines);
  EXPECT_THAT(lines.Text(), testing::HasSubstr("4 of DESIRED_SPEED"));
}

TEST_F(PilotAppTest, WishesThatAreAlwaysRefusedStopTheThrusters) {
  SendNav(), SendWishes();
  for (int i = 0; i < 12; ++i) {
    SendNav(), SendWishesButDepth();
    link_.Send(app_, topics::kDesiredDepth, std::numeric_limits<double>::quiet_NaN());
    Tick();
  }
  EXPECT_TRUE(IsAtRest());
}

TEST_F(PilotAppTest, FliesOnNoEstimateThatIsNotOfThisWorld) {
  SendNav(), SendWishes();
  Tick();
  for (int i = 0; i < 12; ++i) {
    NavState nav;
    nav.down = 1e300, nav.u = std::numeric_limits<double>::quiet_NaN();
    NavState far;
    far.north = 1e300;
    SendWishes();
    app_.Deliver(std::make_shared<const Message>(
        Message{.name = "NAV_STATE",
                .value = TopicCodec<NavState>::Encode(i % 2 == 0 ? nav : far),
                .time = link_.time,
                .source = "pNav",
                .source_aux = "",
                .community = ""}));
    Tick();
    EXPECT_TRUE(AllFinite());
  }
  EXPECT_TRUE(IsAtRest());
  EXPECT_TRUE(HasWarning("REFUSED_NAV_STATE"));
}

TEST_F(PilotAppTest, ItsLastWordIsZero) {
  SendNav(), SendWishes();
  Tick(5);
  EXPECT_FALSE(IsAtRest());
  app_.Finish(link_.time);
  EXPECT_TRUE(IsAtRest());
}

TEST_F(PilotAppTest, StopsAllThrustersAtOnceWhenNavigationIsNotValid) {
  SendNav(), SendWishes();
  Tick(10);
  NavState lost;
  lost.is_valid = false;
  link_.Send(app_, topics::kNavState, lost);
  Tick();
  EXPECT_TRUE(HasWarning("NAV_STALE"));
  EXPECT_EQ(Surge(), 0.0);
}

TEST_F(PilotAppTest, RecoversWhenNavigationComesBack) {
  SendNav(), SendWishes();
  Tick(60);
  SendNav(), SendWishes();
  Tick(10);
  EXPECT_TRUE(app_.warnings().empty());
  EXPECT_GT(Surge(), 0.2);
}

TEST_F(PilotAppTest, LeavesTheThrustersAloneUnderManualOverride) {
  SendNav(), SendWishes();
  Tick(5);
  link_.Send(app_, topics::kManualOverride, true);
  Tick();
  EXPECT_EQ(Surge(), 0.0);
  const std::size_t count = link_.published.size();
  Tick(10);
  EXPECT_EQ(link_.published.size(), count);
}

TEST_F(PilotAppTest, TellsTheOperatorWhatIsWantedAndWhatIs) {
  SendNav(), SendWishes();
  Tick(10);
  ReportLines lines;
  app_.Report(lines);
  EXPECT_THAT(lines.Text(), testing::HasSubstr("Thrusters:    under control"));
  EXPECT_THAT(lines.Text(), testing::HasSubstr("speed [m/s]      0.50  0.00   0.50"));
}

}  // namespace
}  // namespace limpet
