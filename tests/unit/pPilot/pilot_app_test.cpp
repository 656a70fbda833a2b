// SPDX-License-Identifier: MIT
#include "apps/pPilot/pilot_app.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/app/test_link.hpp"

namespace limpet {
namespace {

AppContext ContextFor(TestLink& link) {
  AppContext context;
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

TEST_F(PilotAppTest, SaysNothingBeforeTheHelmHasWishes) {
  SendNav();
  Tick(20);
  EXPECT_FALSE(link_.Last(topics::kThrusterCommand));
}

TEST_F(PilotAppTest, PushesForwardWhenAskedForSpeed) {
  SendNav(), SendWishes();
  Tick(10);
  EXPECT_GT(Surge(), 0.2);
}

TEST_F(PilotAppTest, StopsSurgeAndHoldsDepthWhenTheHelmFallsSilent) {
  SendNav(), SendWishes();
  for (int i = 0; i < 60; ++i) {
    SendNav();
    Tick();
  }
  EXPECT_TRUE(HasWarning("DESIRED_STALE"));
  EXPECT_NEAR(Surge(), 0.0, 0.05);
  EXPECT_GT(link_.Last(topics::kThrusterCommand)->t5, 0.05);  // still holds its buoyancy down
}

TEST_F(PilotAppTest, StopsAllThrustersWhenNavigationFallsSilent) {
  SendNav(), SendWishes();
  for (int i = 0; i < 60; ++i) {
    SendWishes();
    Tick();
  }
  EXPECT_TRUE(HasWarning("NAV_STALE"));
  EXPECT_EQ(Surge(), 0.0);
  EXPECT_EQ(link_.Last(topics::kThrusterCommand)->t5, 0.0);
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
  EXPECT_FALSE(HasWarning("NAV_STALE"));
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
