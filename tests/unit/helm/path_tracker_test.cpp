// SPDX-License-Identifier: MIT
// The path in force: what way counts as flown, and where the next path begins.
#include "limpet/helm/path_tracker.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

NavState NavAt(const Pose2& pose, double speed = 0.5) {
  NavState nav;
  nav.north = pose.north;
  nav.east = pose.east;
  nav.yaw = pose.yaw;
  nav.u = speed;
  return nav;
}

TEST(PathTracker, GuidesAlongItsPathAndCountsTheWay) {
  Random random(1, "tracker");
  for (int run = 0; run < 30; ++run) {
    PathTracker tracker;
    const DubinsPath path({random.Uniform(-9.0, 9.0), random.Uniform(-9.0, 9.0), 0.3},
                          {{random.Uniform(-0.25, 0.25), 8.0}, {0.0, 5.0}});
    tracker.Follow({.source = "beam", .path = path});
    for (double s = 0.0; s <= path.length(); s += 0.25) {
      const auto guidance = tracker.Guide(NavAt(path.At(s)));
      ASSERT_TRUE(guidance);
      EXPECT_EQ(guidance->purpose, "beam");
      EXPECT_NEAR(guidance->cross_track, 0.0, 1e-6);
      EXPECT_NEAR(guidance->remaining, path.length() - s, 1e-6);
      EXPECT_NEAR(tracker.Travelled(), s, 1e-6);
    }
  }
}

TEST(PathTracker, AddsUpThePartsOfPathsThatWereFlown) {
  PathTracker tracker;
  const DubinsPath north({}, {{0.0, 10.0}});
  tracker.Follow({.source = "beam", .path = north});
  for (double s = 0.0; s <= 4.0; s += 0.5)
    static_cast<void>(tracker.Guide(NavAt(north.At(s))));
  const DubinsPath on(north.At(4.0), {{0.0, 10.0}});
  tracker.Follow({.source = "gaps", .path = on});
  EXPECT_NEAR(tracker.Travelled(), 4.0, 1e-6) << "the rest of the first was never flown";
  for (double s = 0.0; s <= 3.0; s += 0.5)
    static_cast<void>(tracker.Guide(NavAt(on.At(s))));
  tracker.Drop();
  EXPECT_NEAR(tracker.Travelled(), 7.0, 1e-6);
  EXPECT_FALSE(tracker.Guide(NavAt({})));
  EXPECT_EQ(tracker.path_id(), 2);
}

TEST(PathTracker, JoinsTheNextPathWhereTheVehicleIsOnceThePresentOneIsFlown) {
  PathTracker tracker;
  tracker.Follow({.source = "home", .path = DubinsPath({}, {})});
  static_cast<void>(tracker.Guide(NavAt({.north = 20.0})));
  EXPECT_EQ(tracker.JoiningPose(NavAt({.north = 20.0}), 1.0).north, 20.0)
      << "it has gone on beyond its end";
}

TEST(PathTracker, JoinsTheNextPathOnThePresentOneWhileNearIt) {
  PathTracker tracker;
  const DubinsPath north({}, {{0.0, 10.0}});
  EXPECT_EQ(tracker.JoiningPose(NavAt({3.0, 1.0, 0.2}), 1.0).north, 3.0) << "there is no path";
  tracker.Follow({.source = "beam", .path = north});
  const NavState near = NavAt({2.0, 0.4, 0.2}), far = NavAt({2.5, 1.8, 0.2});
  static_cast<void>(tracker.Guide(near));
  const Pose2 on = tracker.JoiningPose(near, 1.0);
  EXPECT_NEAR(on.east, 0.0, 1e-9) << "so that the course has no step";
  EXPECT_NEAR(on.yaw, 0.0, 1e-9);
  EXPECT_NEAR(on.north, 2.0, 1e-6);
  static_cast<void>(tracker.Guide(far));
  const Pose2 off = tracker.JoiningPose(far, 1.0);
  EXPECT_EQ(off.east, 1.8);
  EXPECT_EQ(off.yaw, 0.2);
}

}  // namespace
}  // namespace limpet
