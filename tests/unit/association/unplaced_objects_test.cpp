// SPDX-License-Identifier: MIT
#include "estimation/association/unplaced_objects.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double kSure = 2.5;

TrackedObject TrackOf(int boxes, double confidence) {
  TrackedObject track;
  for (int i = 0; i < boxes; ++i) {
    Observation one;
    one.frame = i;
    one.t = 0.25 * i;
    one.color = "yellow";
    one.confidence = confidence;
    track.observations.Add(one);
  }
  track.p_W = {4.0, 1.0, 5.5};
  return track;
}

TEST(UnplacedObjects, AreTracksOfManySureBoxesThatWereDropped) {
  UnplacedObjects unplaced{kSure};
  unplaced.NoteDropped(TrackOf(40, 0.95));
  const std::vector<UnplacedObject> found = unplaced.Without({});
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].color, "yellow");
  EXPECT_EQ(found[0].boxes, 40);
  EXPECT_EQ(found[0].p_W, Eigen::Vector3d(4.0, 1.0, 5.5));
}

TEST(UnplacedObjects, AreNoneOfFewOrUnsureBoxes) {
  UnplacedObjects unplaced{kSure};
  unplaced.NoteDropped(TrackOf(5, 0.95));
  unplaced.NoteDropped(TrackOf(40, 0.5));
  EXPECT_THAT(unplaced.Without({}), IsEmpty());
}

TEST(UnplacedObjects, AreWhatNoImageHolds) {
  UnplacedObjects unplaced{kSure};
  const Box box{.u = 100, .v = 240, .w = 200, .h = 480, .confidence = 0.9, .color = "yellow"};
  for (int i = 0; i < 11; ++i)
    unplaced.NoteUnusable(box, {1.0, 2.0, 3.0}, 0.25 * i);
  EXPECT_THAT(unplaced.Without({}), IsEmpty());
  unplaced.NoteUnusable(box, {1.0, 2.0, 3.0}, 3.0);
  ASSERT_THAT(unplaced.Without({}), SizeIs(1));
  EXPECT_EQ(unplaced.Without({})[0].boxes, 12);
}

TEST(UnplacedObjects, AreNotTheCornersThatManyThingsShowInTurn) {
  UnplacedObjects unplaced{kSure};
  const Box box{.u = 5, .v = 5, .w = 10, .h = 10, .confidence = 0.9, .color = "yellow"};
  for (int i = 0; i < 40; ++i)
    unplaced.NoteUnusable(box, {1.0, 2.0, 3.0}, 6.0 * i);
  EXPECT_THAT(unplaced.Without({}), IsEmpty());
}

TEST(UnplacedObjects, AreForgivenOnceALandmarkStandsThere) {
  UnplacedObjects unplaced{kSure};
  unplaced.NoteDropped(TrackOf(40, 0.95));
  TrackedObject landmark = TrackOf(3, 0.9);
  landmark.Map(1, 0, Confirmed{});
  landmark.p_W = {5.0, 2.0, 8.0};
  EXPECT_THAT(unplaced.Without({landmark}), IsEmpty());
  landmark.p_W = {9.0, 2.0, 5.5};
  EXPECT_THAT(unplaced.Without({landmark}), SizeIs(1));
}

TEST(UnplacedObjects, ThatAreSeenOnAreOneStill) {
  UnplacedObjects unplaced{kSure};
  const Box box{.u = 100, .v = 240, .w = 200, .h = 480, .confidence = 0.9, .color = "yellow"};
  for (int i = 0; i < 36; ++i)
    unplaced.NoteUnusable(box, {1.0 + 0.05 * i, 2.0, 3.0}, 0.25 * i);
  ASSERT_THAT(unplaced.Without({}), SizeIs(1));
  EXPECT_EQ(unplaced.Without({})[0].boxes, 36);
}

TEST(UnplacedObjects, RememberNoMoreThanTheyCanHold) {
  UnplacedObjects unplaced{kSure};
  for (int i = 0; i < 100; ++i) {
    TrackedObject track = TrackOf(20 + i, 0.95);
    track.p_W.x() = 10.0 * i;
    unplaced.NoteDropped(track);
  }
  const std::vector<UnplacedObject> found = unplaced.Without({});
  ASSERT_THAT(found, SizeIs(64));
  EXPECT_EQ(found.back().boxes, 119);
}

}  // namespace
}  // namespace limpet
