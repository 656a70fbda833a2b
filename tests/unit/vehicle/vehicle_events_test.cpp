// SPDX-License-Identifier: MIT
// Surfacing and touching down happen once each, however the vehicle bobs.
#include "limpet/vehicle/vehicle_events.hpp"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

class VehicleEvents : public ::testing::TestWithParam<int> {
 protected:
  static constexpr double kDown = 8.0;
  [[nodiscard]] StateVector AtDepth(double depth) const {
    StateVector x = model_.Afloat({0.0, 0.0}, 0.0);
    x(state_index::kPosition + 2) = depth;
    return x;
  }
  [[nodiscard]] StateVector AtClearance(double clearance) const {
    return AtDepth(kDown - clearance - model_.params().contact.skids_B.front().z());
  }
  /// What a monitor says along a way through these depths [m].
  [[nodiscard]] std::vector<VehicleEvent> Along(const std::vector<StateVector>& way) const {
    EventMonitor monitor(model_, way.front());
    std::vector<VehicleEvent> events;
    for (const StateVector& x : way) {
      const auto guards = monitor.Guards(x, true);
      for (int i = 0; i < EventMonitor::kGuards; ++i) {
        if (guards[static_cast<std::size_t>(i)] < 0.0) events.push_back(monitor.Cross(i));
      }
    }
    return events;
  }
  const VehicleModel model_{VehicleParams{}, Eigen::Vector3d::Zero(),
                            [](const Eigen::Vector2d&) { return kDown; }};
  Random random_{static_cast<std::uint64_t>(GetParam()), "events"};
};

TEST_P(VehicleEvents, BobbingBetweenTheTwoThresholdsIsNoEvent) {
  const VehicleParams& params = model_.params();
  std::vector<StateVector> surface, bottom;
  for (int i = 0; i < 200; ++i) {
    surface.push_back(AtDepth(random_.Uniform(params.surfaced_depth_m, params.submerged_depth_m)));
    bottom.push_back(
        AtClearance(random_.Uniform(params.touch_clearance_m, params.leave_clearance_m)));
  }
  EXPECT_TRUE(Along(surface).empty());
  EXPECT_TRUE(Along(bottom).empty());
}

TEST_P(VehicleEvents, AWayDownAndUpSaysEachOnceInOrder) {
  std::vector<StateVector> way;
  for (double depth = 0.05; depth < kDown - 0.16; depth += random_.Uniform(0.005, 0.04))
    way.push_back(AtDepth(depth));
  for (std::size_t i = way.size(); i-- > 0;)
    way.push_back(way[i]);
  EXPECT_EQ(Along(way), (std::vector{VehicleEvent::kSubmerged, VehicleEvent::kTouchedBottom,
                                     VehicleEvent::kLeftBottom, VehicleEvent::kSurfaced}));
}

TEST_P(VehicleEvents, AGuardIsPositiveWhereItsConditionHoldsAndFallsTowardsTheOther) {
  EventMonitor monitor(model_, AtDepth(0.1));
  const double near = random_.Uniform(0.05, 0.15), nearer = near + random_.Uniform(0.001, 0.05);
  EXPECT_GT(monitor.Guards(AtDepth(near), false)[0], monitor.Guards(AtDepth(nearer), false)[0]);
  EXPECT_EQ(monitor.Cross(0), VehicleEvent::kSubmerged);
  const double deep = random_.Uniform(1.0, 5.0);
  EXPECT_GT(monitor.Guards(AtDepth(deep), false)[0], monitor.Guards(AtDepth(deep - 0.5), false)[0]);
}

TEST_P(VehicleEvents, ItHasSurfacedAtTheShallowerThresholdAlone) {
  const VehicleParams& params = model_.params();
  const double between =
      random_.Uniform(params.surfaced_depth_m + 1e-6, params.submerged_depth_m - 1e-6);
  EXPECT_TRUE(Along({AtDepth(2.0), AtDepth(between)}).empty());
  EXPECT_EQ(Along({AtDepth(2.0), AtDepth(params.surfaced_depth_m - 1e-6)}),
            (std::vector{VehicleEvent::kSurfaced}));
}

TEST_P(VehicleEvents, FarFromTheSeabedItsGuardIsLeftOut) {
  const EventMonitor monitor(model_, AtDepth(1.0));
  EXPECT_EQ(monitor.Guards(AtClearance(-0.1), false)[1], 1.0);
  EXPECT_LT(monitor.Guards(AtClearance(-0.1), true)[1], 0.0);
}

INSTANTIATE_TEST_SUITE_P(Drawn, VehicleEvents, ::testing::Range(1, 6));

TEST(EventName, IsOneWordOfItsOwnForEachEvent) {
  EXPECT_EQ(EventName(VehicleEvent::kSurfaced), "surfaced");
  EXPECT_EQ(EventName(VehicleEvent::kSubmerged), "submerged");
  EXPECT_EQ(EventName(VehicleEvent::kTouchedBottom), "touched_bottom");
  EXPECT_EQ(EventName(VehicleEvent::kLeftBottom), "left_bottom");
}

}  // namespace
}  // namespace limpet
