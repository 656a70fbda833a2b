// SPDX-License-Identifier: MIT
#include "estimation/association/track_list.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/association/association_draws.hpp"

namespace limpet {
namespace {

TrackedObject TrackAt(const Eigen::Vector3d& p_W, int id, const TrackState& state,
                      double last_seen = 0.0) {
  TrackedObject object;
  object.p_W = p_W;
  Observation one;
  one.t = last_seen;
  object.observations.Add(one);
  object.Map(id, id, state);
  return object;
}

/// Landmarks in a field of that size, at about one depth.
std::vector<TrackedObject> DrawLandmarks(Random& random, double field_m) {
  std::vector<TrackedObject> objects;
  for (std::uint64_t i = random.Index(12) + 1; i > 0; --i) {
    const Eigen::Vector3d p_W(random.Uniform(0.0, field_m), random.Uniform(0.0, field_m),
                              random.Uniform(6.0, 6.5));
    objects.push_back(TrackAt(p_W, static_cast<int>(i), Confirmed{}));
  }
  return objects;
}

TEST(TrackList, FindsWhatIsMappedByItsIdAlsoWhenItIsGone) {
  TrackList tracks;
  tracks.objects = {TrackAt({0, 0, 0}, 1, Confirmed{}), TrackAt({1, 0, 0}, 2, Gone{}),
                    TrackedObject()};
  ASSERT_NE(tracks.FindById(1), nullptr);
  EXPECT_EQ(tracks.FindById(1)->id(), 1);
  ASSERT_NE(tracks.FindById(2), nullptr);
  EXPECT_EQ(tracks.FindById(3), nullptr);
}

TEST(TrackList, ATrackIsTheLandmarkThatItsTiesLeadTo) {
  TrackList tracks;
  tracks.objects = {TrackAt({0, 0, 0}, 1, Confirmed{}),   TrackAt({0, 0, 0}, 2, Tied{.to = 1}),
                    TrackAt({0, 0, 0}, 3, Tied{.to = 2}), TrackAt({0, 0, 0}, 4, InDoubt{}),
                    TrackAt({0, 0, 0}, 5, Tied{.to = 4}), TrackAt({0, 0, 0}, 6, Tied{.to = 99})};
  const std::vector<std::optional<int>> expected{1, 1, 1, std::nullopt, std::nullopt, std::nullopt};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(tracks.LandmarkIdOf(tracks.objects[i]), expected[i]) << "track " << i + 1;
  EXPECT_EQ(tracks.LandmarkIdOf(TrackedObject()), std::nullopt);
}

TEST(TrackList, WhatIsTiedToALandmarkVotesForItsClassAsLongAsTheTieHolds) {
  const auto seen_as = [](int id, const TrackState& state, const char* color, int boxes) {
    TrackedObject object;
    for (int i = 0; i < boxes; ++i) {
      Observation one;
      one.color = color, one.confidence = 0.9;
      object.observations.Add(one);
    }
    object.Map(id, id, state);
    return object;
  };
  TrackList tracks;
  tracks.objects = {seen_as(1, Confirmed{}, "orange", 4), seen_as(2, Tied{.to = 1}, "yellow", 3),
                    seen_as(3, Tied{.to = 2}, "yellow", 2), seen_as(4, InDoubt{}, "orange", 9),
                    seen_as(5, Confirmed{}, "red", 1)};
  const BoxesTogether tied = tracks.BoxesOf(tracks.objects[0]);
  EXPECT_EQ(tied.color, "yellow");
  EXPECT_EQ(tied.count, 9);
  tracks.objects[2].state = InDoubt{};
  const BoxesTogether released = tracks.BoxesOf(tracks.objects[0]);
  EXPECT_EQ(released.color, "orange");
  EXPECT_EQ(released.count, 7);
  EXPECT_EQ(tracks.BoxesOf(tracks.objects[4]).color, "red");
}

TEST(TrackList, NearIsNearerThanTheDistanceAndNotTied) {
  TrackList tracks;
  tracks.objects = {TrackAt({2.99, 0, 0}, 1, Confirmed{}), TrackAt({3.01, 0, 0}, 2, Confirmed{}),
                    TrackAt({0, 1.0, 0}, 3, InDoubt{}), TrackAt({0, 0, 1.0}, 4, Tied{.to = 1}),
                    TrackAt({0, 0, 0.5}, 5, Gone{})};
  std::vector<int> ids;
  for (const TrackedObject* near : tracks.UntiedNear({0, 0, 0}, 3.0))
    ids.push_back(near->id());
  EXPECT_EQ(ids, (std::vector<int>{1, 3}));
}

TEST(TrackList, BoxesOfAPassStayWithTheTrackOfThatPass) {
  constexpr double kPause = 20.0;
  TrackList tracks;
  tracks.objects = {TrackAt({0, 0, 0}, 1, Confirmed{}), TrackAt({0, 0, 0}, 2, Tied{.to = 1}, 50.0)};
  const auto takes = [&](std::size_t i) {
    return tracks.TakesObservations(tracks.objects[i], kPause);
  };
  tracks.now = 50.0 + kPause;
  EXPECT_FALSE(takes(0)) << "the tied track of this pass takes them";
  EXPECT_TRUE(takes(1));
  tracks.now += 1e-6;
  EXPECT_TRUE(takes(0)) << "that pass is over";
  EXPECT_FALSE(takes(1));
}

TEST(TrackList, AtAnyTimeJustOneOfATrackAndWhatIsTiedToItTakesBoxes) {
  TrackList tracks;
  tracks.objects = {TrackAt({0, 0, 0}, 1, Confirmed{}), TrackAt({0, 0, 0}, 2, Tied{.to = 1}, 30.0)};
  for (tracks.now = 30.0; tracks.now < 90.0; tracks.now += 0.7) {
    EXPECT_EQ(std::ranges::count_if(tracks.objects,
                                    [&](const TrackedObject& object) {
                                      return tracks.TakesObservations(object, 20.0);
                                    }),
              1)
        << tracks.now;
  }
}

TEST(TrackList, WhatHasNoBoxesLeftIsErasedAndNothingElse) {
  TrackList tracks;
  tracks.objects = {TrackAt({0, 0, 0}, 1, Confirmed{}), TrackedObject(),
                    TrackAt({0, 0, 0}, 3, InDoubt{})};
  tracks.EraseEmpty();
  ASSERT_EQ(tracks.objects.size(), 2U);
  EXPECT_EQ(tracks.objects[0].id(), 1);
  EXPECT_EQ(tracks.objects[1].id(), 3);
}

TEST(Neighbours, AreMutual) {
  Random random(51);
  for (int i = 0; i < 200; ++i) {
    const std::vector<TrackedObject> objects = DrawLandmarks(random, 8.0);
    int pairs = 0;
    for (std::size_t a = 0; a < objects.size(); ++a) {
      for (std::size_t b = a + 1; b < objects.size(); ++b)
        pairs += (objects[a].p_W - objects[b].p_W).norm() < 2.0 ? 1 : 0;
    }
    int counted = 0;
    for (const TrackedObject& object : objects)
      counted += CountNeighbours(object, objects, 2.0);
    EXPECT_EQ(counted, 2 * pairs);
  }
}

TEST(Neighbours, OnlyLandmarksCountAndNoneCountsItself) {
  std::vector<TrackedObject> objects{TrackAt({0, 0, 0}, 1, Confirmed{}),
                                     TrackAt({1, 0, 0}, 2, InDoubt{}),
                                     TrackAt({0, 1, 0}, 3, Tied{.to = 1})};
  EXPECT_EQ(CountNeighbours(objects[0], objects, 2.0), 0);
  EXPECT_EQ(CountNeighbours(objects[1], objects, 2.0), 1);
}

TEST(Clustering, IsThatOfTheFieldHoweverItIsListedAndWhereverItLies) {
  Random random(52);
  for (int i = 0; i < 200; ++i) {
    std::vector<TrackedObject> objects = DrawLandmarks(random, 8.0);
    const Clustering before = ClusteringOf(objects, 2.0);
    std::ranges::shuffle(objects, random.engine());
    const WorldChange change = DrawWorldChange(random);
    for (TrackedObject& object : objects)
      object.p_W = change.Apply(object.p_W);
    const Clustering after = ClusteringOf(objects, 2.0);
    EXPECT_NEAR(after.pair_density, before.pair_density, 1e-12);
    EXPECT_NEAR(after.crowding, before.crowding, 1e-12);
  }
}

TEST(Clustering, IsAShareAndADensityThatNoCrowdExceeds) {
  Random random(53);
  for (int i = 0; i < 200; ++i) {
    const Clustering found = ClusteringOf(DrawLandmarks(random, random.Uniform(1.0, 30.0)), 2.0);
    EXPECT_GE(found.crowding, 0.0);
    EXPECT_LT(found.crowding, 1.0);
    EXPECT_GE(found.pair_density, 0.0);
    EXPECT_LT(found.pair_density, 1.0 / (4.0 * std::numbers::pi));
  }
}

TEST(Clustering, WhereNothingIsPairedNoPairIsExpected) {
  std::vector<TrackedObject> objects;
  EXPECT_EQ(ClusteringOf(objects, 2.0).pair_density, 0.0);
  for (int i = 1; i < 6; ++i) {
    objects.push_back(TrackAt({10.0 * i, 0, 0}, i, Confirmed{}));
    EXPECT_EQ(ClusteringOf(objects, 2.0).pair_density, 0.0);
  }
}

TEST(Clustering, MorePairsMakePairsMoreExpected) {
  std::vector<TrackedObject> pairs;
  double before = 0.0;
  for (int i = 1; i < 6; ++i) {
    pairs.push_back(TrackAt({20.0 * i, 0, 0}, 2 * i, Confirmed{}));
    pairs.push_back(TrackAt({20.0 * i, 1.5, 0}, 2 * i + 1, Confirmed{}));
    const double now = ClusteringOf(pairs, 2.0).pair_density;
    EXPECT_GT(now, before);
    before = now;
  }
}

TEST(Clustering, ThreesMakeAThirdMoreExpectedThanPairsDo) {
  std::vector<TrackedObject> pairs, threes;
  for (int i = 1; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) {
      const TrackedObject object = TrackAt({20.0 * i, 1.0 * k, 0}, 3 * i + k, Confirmed{});
      threes.push_back(object);
      if (k < 2) pairs.push_back(object);
    }
  }
  EXPECT_GT(ClusteringOf(threes, 2.0).crowding, ClusteringOf(pairs, 2.0).crowding);
}

}  // namespace
}  // namespace limpet
