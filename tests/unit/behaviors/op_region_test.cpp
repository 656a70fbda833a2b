// SPDX-License-Identifier: MIT
#include <numbers>

#include <gtest/gtest.h>

#include "behaviors/BHV_OpRegion.hpp"

namespace limpet {
namespace {

const SurveyArea kRegionArea{-10.0, 10.0, -10.0, 10.0, 2.0, 2.0};

VehicleState StateAt(double north, const std::string& purpose = "") {
  VehicleState state;
  state.nav.north = north;
  state.area = kRegionArea;
  if (!purpose.empty()) {
    state.guidance = Guidance{.purpose = purpose};
  }
  return state;
}

/// What the behavior offers to a vehicle at `start`.
struct Offered {
  explicit Offered(const Pose2& start) {
    now.pose = start;
    now.ground = &ground;
    now.region = &region;
    behavior.Offer(now, options);
  }
  [[nodiscard]] std::optional<Bid> Value(const Option& option) {
    const Prospect prospect{.option = &option, .sight = {}};
    return behavior.Value(prospect, now);
  }
  BHV_OpRegion behavior{{}};
  SurveyGrid grid{kRegionArea};
  Ground ground{grid, Footprint(4.0, 2.0, CameraGeometry{})};
  Region region{kRegionArea};
  Situation now;
  std::vector<Option> options;
};

TEST(BhvOpRegion, OffersTheWayInFromAnyStartOutside) {
  for (const double away : {5.0, 50.0, 120.0}) {
    for (int i = 0; i < 16; ++i) {
      const double bearing = 2.0 * std::numbers::pi * i / 16;
      const Pose2 start{(12.0 + away) * std::cos(bearing) * 1.5,
                        (12.0 + away) * std::sin(bearing) * 1.5, 0.7 * i};
      Offered offered(start);
      ASSERT_EQ(offered.options.size(), 1U);
      const Option& transit = offered.options.front();
      EXPECT_EQ(transit.source, "transit");
      EXPECT_TRUE(offered.region.IsRecoverable(transit.path.end(), offered.now.turn_radius));
      EXPECT_LT(transit.path.length(), offered.region.Outside(start) + 25.0);
      EXPECT_FALSE(offered.Value(transit)->veto);
    }
  }
}

TEST(BhvOpRegion, OffersNothingInside) { EXPECT_TRUE(Offered({0.0, 0.0, 0.0}).options.empty()); }

TEST(BhvOpRegion, LeavesTheWayInToOthersWhereTheyKnowOne) {
  Offered offered({40.0, 0.0, 0.0});
  std::vector<Option> options = offered.options;
  offered.behavior.Offer(offered.now, options);
  EXPECT_EQ(options.size(), 1U);
}

TEST(BhvOpRegion, DoesNotTakeTheWayHomeForAWayIn) {
  Offered offered({40.0, 0.0, 0.0});
  std::vector<Option> options = offered.options;
  options.front().source = "home";
  offered.behavior.Offer(offered.now, options);
  EXPECT_EQ(options.size(), 2U);
}

TEST(BhvOpRegion, IsInForceOnlyOnceEntered) {
  BHV_OpRegion behavior({});
  behavior.Start(StateAt(60.0));
  EXPECT_FALSE(behavior.Move(StateAt(60.0, "transit")).warning);
  EXPECT_FALSE(behavior.Move(StateAt(5.0, "beam")).warning);
  EXPECT_EQ(behavior.Move(StateAt(13.0, "beam")).warning->id, "OUTSIDE_REGION");
}

TEST(BhvOpRegion, LetsTheWayHomeLeave) {
  BHV_OpRegion behavior({});
  behavior.Start(StateAt(5.0));
  static_cast<void>(behavior.Move(StateAt(5.0, "home")));
  EXPECT_FALSE(behavior.Move(StateAt(30.0, "home")).warning);
}

}  // namespace
}  // namespace limpet
