// SPDX-License-Identifier: MIT
#include "behaviors/BHV_SurfaceFix.hpp"

#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

namespace limpet {
namespace {

const SurveyArea kFixArea{-10.0, 10.0, -10.0, 10.0, 2.0, 2.0};

class SurfaceFixTest : public ::testing::Test {
 protected:
  SurfaceFixTest() {
    state_.area = kFixArea;
    state_.nav.down = 3.5;
  }
  MotionBid Move(double sigma, const std::string& purpose = "beam") {
    state_.nav.sd_north = state_.nav.sd_east = sigma;
    state_.guidance = Guidance{.purpose = purpose};
    return behavior_.Move(state_);
  }
  /// What SURFACE_FIX is posted as; empty if it is not.
  static std::string Posted(const MotionBid& bid) {
    std::string last;
    for (const BehaviorAct& act : bid.acts) {
      if (const auto* post = std::get_if<BehaviorPost>(&act))
        last = std::get<std::string>(post->value);
    }
    return last;
  }
  /// 10 m due north at so far east; the border is at 12.
  [[nodiscard]] double ValueOf(double east, const std::string& source) const {
    const Option option{
        .source = source,
        .path = DubinsPath({.north = -5.0, .east = east, .yaw = 0.0}, {{0.0, 10.0}})};
    const auto bid = behavior_.Value(Prospect(option, {}), {});
    return bid ? bid->value : 0.0;
  }
  [[nodiscard]] std::size_t Offered() const {
    std::vector<Option> options{{.source = "beam", .path = DubinsPath(Pose2{}, {{0.0, 20.0}})}};
    Situation now;
    now.now = state_.now;
    behavior_.Offer(now, options);
    return options.size() - 1;
  }

  VehicleState state_;
  BHV_SurfaceFix behavior_{{}};
};

TEST_F(SurfaceFixTest, HasNoSayWhileThePlaceIsKnownAsWellAsAfterAFix) {
  static_cast<void>(Move(0.4));
  EXPECT_EQ(Offered(), 0U);
  EXPECT_EQ(ValueOf(11.0, "beam"), 0.0);
}

TEST_F(SurfaceFixTest, ChargesTheWayAlongABorderThatThreeSigmasReachOver) {
  static_cast<void>(Move(1.0));
  EXPECT_EQ(ValueOf(0.0, "beam"), 0.0);
  EXPECT_LT(ValueOf(11.0, "beam"), -10.0);
}

TEST_F(SurfaceFixTest, WouldRatherComeUpThanGoAlongTheBorderInDoubt) {
  static_cast<void>(Move(1.5));
  EXPECT_EQ(Offered(), 1U);
  EXPECT_GT(ValueOf(11.0, "surface_fix"), ValueOf(11.0, "beam"));
  EXPECT_LT(ValueOf(0.0, "surface_fix"), ValueOf(0.0, "beam")) << "in the middle it goes on";
}

TEST_F(SurfaceFixTest, ComesUpOnceThatIsChosenAndGoesOnWhenThePlaceIsKnown) {
  EXPECT_EQ(Posted(Move(1.5)), "");
  EXPECT_EQ(Posted(Move(1.5, "surface_fix")), "true");
  state_.now += Seconds(30.0);
  state_.nav.down = 0.1;
  EXPECT_EQ(Posted(Move(0.9, "")), "");
  state_.now += Seconds(25.0);
  state_.nav.gps.is_valid = true;
  EXPECT_EQ(Posted(Move(0.9, "")), "") << "not yet";
  EXPECT_EQ(Posted(Move(0.45, "")), "false");
  EXPECT_EQ(Offered(), 0U) << "not again at once";
}

TEST_F(SurfaceFixTest, GoesOnAfterTheLongestStayWithoutFixes) {
  static_cast<void>(Move(1.5, "surface_fix"));
  state_.nav.down = 0.1;
  static_cast<void>(Move(1.5, ""));
  state_.now += BHV_SurfaceFix::Params{}.longest_stay;
  EXPECT_EQ(Posted(Move(1.5, "")), "false");
}

TEST_F(SurfaceFixTest, LeavesNoAscentBehindWhenTheMissionEndsIt) {
  static_cast<void>(Move(1.5, "surface_fix"));
  EXPECT_EQ(behavior_.Stop(state_).size(), 1U);
  EXPECT_TRUE(behavior_.Stop(state_).empty());
}

}  // namespace
}  // namespace limpet
