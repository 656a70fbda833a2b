// SPDX-License-Identifier: MIT
// What pSurvey says of the energy, and that it goes home where nothing else is in reach.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/pSurvey/survey_app_parts.hpp"

namespace limpet {
namespace {

class SurveyEnergyTest : public ::testing::Test {
 protected:
  explicit SurveyEnergyTest(const char* vehicle = "feelhippo.yaml") {
    if (*vehicle != '\0') context_.globals = {{"VehicleFile", vehicle, {}}};
    app_.emplace(context_, OfTable());
  }
  void Tick(double seconds) {
    link_.time += Seconds(seconds);
    link_.Send(*app_, topics::kNavState, nav_);
    app_->Tick(link_.time);
  }
  void ReachSurvey() {
    nav_.altitude = 7.5;
    Tick(1.0);
    link_.Send(*app_, topics::kDeploy, true);
    Tick(301.0);
    nav_.down = 3.5;
    nav_.altitude = 4.0;
    Tick(1.0);
  }
  void SayBattery(double charge) {
    link_.Send(*app_, topics::kBattery,
               BatteryState{.charge = charge, .volts = 26.0, .amperes = 3.0});
  }

  TestLink link_;
  AppContext context_ = ContextOn(link_);
  std::optional<SurveyApp> app_;
  NavState nav_;
};

class WithoutBattery : public SurveyEnergyTest {
 protected:
  WithoutBattery() : SurveyEnergyTest("") {}
};

TEST_F(SurveyEnergyTest, SaysWhatIsLeftAndWhatTheWayHomeTakes) {
  ReachSurvey();
  nav_.north = 200.0;
  Tick(0.1);
  SayBattery(0.5);
  const auto state = link_.Last(topics::kEnergyState);
  ASSERT_TRUE(state.has_value());
  EXPECT_NEAR(state->left_wh, 0.5 * state->capacity_wh, 1e-6);
  EXPECT_GT(state->home_wh, 200.0 * state->metre_wh);
  EXPECT_NEAR(state->reserve_wh, 0.15 * state->capacity_wh, 1e-6);
  ReportLines lines;
  app_->Report(lines);
  EXPECT_THAT(lines.Text(), testing::HasSubstr("Energy:"));
}

TEST_F(SurveyEnergyTest, SaysWhatAMetreTakesByCourseOnceACurrentMakesADifference) {
  ReachSurvey();
  const auto say = [this](double north) {
    link_.Send(*app_, topics::kNavCurrent, WaterCurrent{.north = north, .east = 0.0, .sd = 0.01});
  };
  say(0.01);
  EXPECT_FALSE(link_.Last(topics::kCourseCost).has_value());
  say(-0.2);
  const auto dear = link_.Last(topics::kCourseCost);
  ASSERT_TRUE(dear.has_value());
  EXPECT_GT(dear->At(0.0), 1.2);
  say(-0.202);
  EXPECT_EQ(link_.Last(topics::kCourseCost)->metres, dear->metres) << "for next to nothing";
  say(0.01);
  EXPECT_TRUE(link_.Last(topics::kCourseCost)->metres.empty());
}

TEST_F(WithoutBattery, SaysNothingOfEnergy) {
  ReachSurvey();
  link_.Send(*app_, topics::kNavCurrent, WaterCurrent{.north = 0.2, .east = 0.0, .sd = 0.01});
  EXPECT_FALSE(link_.Last(topics::kCourseCost).has_value());
  SayBattery(0.5);
  EXPECT_FALSE(link_.Last(topics::kEnergyState).has_value());
}

TEST_F(SurveyEnergyTest, GoesHomeWhenTheHelmHasNothingElseInReach) {
  ReachSurvey();
  link_.Send(*app_, topics::kHelmPath, HelmPath{.segments = {}, .purpose = "beam"});
  EXPECT_EQ(link_.Last(topics::kSurveyPhase), "SURVEY");
  link_.Send(*app_, topics::kHelmPath, HelmPath{.segments = {}, .purpose = "home"});
  EXPECT_EQ(link_.Last(topics::kSurveyPhase), "RETURN");
}

}  // namespace
}  // namespace limpet
