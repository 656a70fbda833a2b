// SPDX-License-Identifier: MIT
// Which frames speak against an object because they should have shown it.
#include "estimation/association/visibility.hpp"

#include <gtest/gtest.h>

#include "tests/unit/association/tracks_fixture.hpp"

namespace limpet {
namespace {

class VisibilityTest : public TracksFixture {
 protected:
  /// A track at a place in the camera's frame of a level vehicle at the origin.
  TrackedObject& At(const Eigen::Vector3d& p_C, const TrackState& state, double last_seen = 0.0) {
    TrackedObject object;
    object.p_W = camera_.R_BC * p_C;
    object.sightings.max_distance = 4.0;
    Observation one;
    one.t = last_seen;
    object.observations.Add(one);
    const int id = static_cast<int>(tracks_.objects.size()) + 1;
    if (!std::holds_alternative<Tentative>(state)) object.Map(id, id, state);
    tracks_.objects.push_back(object);
    return tracks_.objects.back();
  }
  void Count(const std::vector<std::size_t>& seen = {}) {
    CountVisibility({}, seen, mount_, params_, tracks_);
  }
  /// True if a frame without its box counts against an object there.
  bool IsExpected(const Eigen::Vector3d& p_C) {
    tracks_.objects.clear();
    At(p_C, Confirmed{});
    Count();
    return tracks_.objects[0].sightings.expected == 1;
  }
};

TEST_F(VisibilityTest, AnObjectThatABoxShowsWasExpectedAndHit) {
  At({0, 0, 3}, Confirmed{});
  At({9, 9, 3}, Confirmed{});  // out of sight, and seen all the same
  Count({0, 1});
  for (const TrackedObject& object : tracks_.objects) {
    EXPECT_EQ(object.sightings.expected, 1);
    EXPECT_EQ(object.sightings.hits, 1);
  }
}

TEST_F(VisibilityTest, HitsAreNeverMoreThanExpected) {
  Random random(81);
  for (int i = 0; i < 6; ++i)
    At({random.Normal(1.0), random.Normal(1.0), random.Uniform(2.0, 5.0)}, Confirmed{});
  for (int frame = 0; frame < 100; ++frame) {
    std::vector<std::size_t> seen;
    for (std::size_t i = 0; i < tracks_.objects.size(); ++i) {
      if (random.Chance(0.4)) seen.push_back(i);
    }
    Count(seen);
  }
  for (const TrackedObject& object : tracks_.objects) {
    EXPECT_LE(object.sightings.hits, object.sightings.expected);
    EXPECT_GT(object.sightings.hits, 0);
  }
}

TEST_F(VisibilityTest, AnObjectNearTheBorderNeedNotShow) {
  // Twelve percent of the image from each of its borders.
  const double across = 3.0 * 0.38 * camera_.width_px / camera_.fx;
  const double along = 3.0 * 0.38 * camera_.height_px / camera_.fy;
  for (const double side : {-1.0, 1.0}) {
    EXPECT_TRUE(IsExpected({side * (across - 0.001), 0.0, 3.0}));
    EXPECT_FALSE(IsExpected({side * (across + 0.001), 0.0, 3.0}));
    EXPECT_TRUE(IsExpected({0.0, side * (along - 0.001), 3.0}));
    EXPECT_FALSE(IsExpected({0.0, side * (along + 0.001), 3.0}));
  }
}

TEST_F(VisibilityTest, AnObjectFurtherAwayThanItWasEverSeenNeedNotShow) {
  EXPECT_TRUE(IsExpected({0.0, 0.0, 4.499}));
  EXPECT_FALSE(IsExpected({0.0, 0.0, 4.501}));
}

TEST_F(VisibilityTest, AnObjectRightBelowOrBehindTheCameraNeedNotShow) {
  EXPECT_FALSE(IsExpected({0.0, 0.0, 0.499}));
  EXPECT_TRUE(IsExpected({0.0, 0.0, 0.501}));
  EXPECT_FALSE(IsExpected({0.0, 0.0, -2.0}));
}

TEST_F(VisibilityTest, TheWayTheVehicleHeadsDoesNotMatter) {
  Random random(82);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d p_C(random.Normal(1.5), random.Normal(1.2), random.Uniform(0.3, 5.0));
    const bool expected = IsExpected(p_C);
    const NavVector x = DrawPose(random);
    tracks_.objects[0].p_W = InWorld(camera_, x, p_C);
    CountVisibility({.x = x}, {}, mount_, params_, tracks_);
    EXPECT_EQ(tracks_.objects[0].sightings.expected, expected ? 2 : 0);
  }
}

TEST_F(VisibilityTest, AFrameOfATiedTracksPassCountsForTheTiedTrackAlone) {
  At({0, 0, 3}, Confirmed{});
  At({0, 0, 3}, Tied{.to = 1, .since = 0.0}, 50.0);
  tracks_.now = 60.0;
  Count({1});
  EXPECT_EQ(tracks_.objects[0].sightings.expected, 0);
  EXPECT_EQ(tracks_.objects[1].sightings.expected, 1);
  tracks_.now = 90.0;  // that pass is over
  Count();
  EXPECT_EQ(tracks_.objects[0].sightings.expected, 1);
  EXPECT_EQ(tracks_.objects[1].sightings.expected, 1);
}

TEST_F(VisibilityTest, ALandmarkIsNotMissedWhereWhatMayBeItIsSeen) {
  At({0, 0, 3}, Confirmed{});
  At({params_.merge_distance_m - 0.01, 0, 3}, InDoubt{});
  Count({1});
  EXPECT_EQ(tracks_.objects[0].sightings.expected, 0);
  tracks_.objects[1].p_W = camera_.R_BC * Eigen::Vector3d(params_.merge_distance_m + 0.01, 0, 3);
  Count({1});
  EXPECT_EQ(tracks_.objects[0].sightings.expected, 1);
  tracks_.objects[1].p_W = tracks_.objects[0].p_W;
  tracks_.objects[1].state = Confirmed{};
  Count({1});
  EXPECT_EQ(tracks_.objects[0].sightings.expected, 2)
      << "a landmark that is decided is not another one";
}

}  // namespace
}  // namespace limpet
