// SPDX-License-Identifier: MIT
// Which tracks in doubt are landmarks known before, and when that is decided.
#include "estimation/association/identity_decisions.hpp"

#include <gtest/gtest.h>

#include "tests/unit/association/tracks_fixture.hpp"

namespace limpet {
namespace {

const Eigen::Vector3d kKnown(4.0, 1.0, 6.0);
constexpr double kOutOfViewSeconds = 2.0;

class IdentityDecisionsTest : public TracksFixture {
 protected:
  /// Time goes by elsewhere.
  void Wait(double seconds) { tracks_.now += seconds; }
  bool Decide() {
    const bool has_changed = identities_.DecideWhatIsDue();
    Solve();
    return has_changed;
  }
  void Conclude() {
    identities_.Conclude();
    Solve();
  }
  /// A landmark, and a track in doubt of a second visit with that drift.
  void SeeTwice(const Eigen::Vector3d& then, const Eigen::Vector3d& now, double drift) {
    Mapped(then, FlyOver(then), Confirmed{});
    FlyTo(then.x() + 20.0, then.y(), drift);
    Mapped(now, FlyOver(now, drift), InDoubt{}).drift_sd = drift;
  }
  /// Two landmarks, and a track that may be either: half way between them, after a drift as large.
  void SeeBetweenTwo() {
    Mapped(kKnown, FlyOver(kKnown), Confirmed{});
    const Eigen::Vector3d other = kKnown + Eigen::Vector3d(0.0, 1.6, 0.0);
    Mapped(other, FlyOver(other), Confirmed{});
    FlyTo(24.0, 0.0, 1.0);
    const Eigen::Vector3d between = kKnown + Eigen::Vector3d(0.0, 0.8, 0.0);
    Mapped(between, FlyOver(between, 1.0), InDoubt{}).drift_sd = 1.0;
    Wait(kOutOfViewSeconds + 0.01);
    Decide();
  }
  IdentityDecisions identities_{smoother_, params_, tracks_, terms_};
};

TEST_F(IdentityDecisionsTest, WhatIsSeenAgainWhereItWasIsTiedOnceItIsOutOfView) {
  SeeTwice(kKnown, kKnown, 0.1);
  EXPECT_FALSE(Decide()) << "more boxes are still to come";
  Wait(kOutOfViewSeconds + 0.01);
  EXPECT_TRUE(Decide());
  ASSERT_EQ(tracks_.objects.size(), 2U);
  EXPECT_TRUE(tracks_.objects[1].IsTiedTo(tracks_.objects[0].id()));
  EXPECT_GT(tracks_.objects[1].verdict.share, 0.98);
}

TEST_F(IdentityDecisionsTest, WhatIsFarFromAllThatIsKnownIsNew) {
  SeeTwice(kKnown, kKnown + Eigen::Vector3d(3.0, 0.0, 0.0), 0.1);
  Wait(kOutOfViewSeconds + 0.01);
  Decide();
  EXPECT_EQ(CountLandmarks(), 2U);
  EXPECT_TRUE(tracks_.objects[1].verdict.is_likely_new);
}

TEST_F(IdentityDecisionsTest, WhatMayBeOneOrAnotherIsLeftInDoubt) {
  SeeBetweenTwo();
  EXPECT_TRUE(tracks_.objects[2].Is<InDoubt>());
  EXPECT_LT(tracks_.objects[2].verdict.share, 0.98);
}

TEST_F(IdentityDecisionsTest, WhatIsOutOfViewForTwoSecondsIsDecidedAndNotBefore) {
  SeeTwice(kKnown, kKnown, 0.1);
  Wait(kOutOfViewSeconds - 0.01);
  EXPECT_FALSE(Decide());
  Wait(0.02);
  EXPECT_TRUE(Decide());
}

TEST_F(IdentityDecisionsTest, WhatStaysInViewIsDecidedAfterEightSeconds) {
  SeeTwice(kKnown, kKnown, 0.1);
  TrackedObject& object = tracks_.objects[1];
  for (const double in_view : {7.99, 8.01}) {
    tracks_.now = object.observations.front().t + in_view;
    object.observations.back().t = tracks_.now;  // and a box has just come
    EXPECT_EQ(Decide(), in_view > 8.0);
  }
}

TEST_F(IdentityDecisionsTest, ADoubtIsLookedAtAgainThreeSecondsAfterNewsAndElseEveryMinute) {
  SeeBetweenTwo();
  ASSERT_TRUE(tracks_.objects[2].Is<InDoubt>());
  const auto is_decided = [&](int news, double after) {
    tracks_.objects[2].verdict.share = -1.0;  // so that a decision shows
    tracks_.identity_news = news;
    Wait(after);
    Decide();
    return tracks_.objects[2].verdict.share >= 0.0;
  };
  EXPECT_FALSE(is_decided(1, 2.99));
  EXPECT_TRUE(is_decided(1, 0.02));
  EXPECT_FALSE(is_decided(0, 59.9));
  EXPECT_TRUE(is_decided(0, 0.2));
}

TEST_F(IdentityDecisionsTest, WithoutNewsNothingIsDecidedAgainWithinAMinute) {
  SeeTwice(kKnown, kKnown, 0.1);
  Wait(kOutOfViewSeconds + 0.01);
  Decide();
  ASSERT_TRUE(tracks_.objects[1].Is<Tied>());
  tracks_.objects[1].verdict.share = -1.0;  // so that a decision shows
  tracks_.identity_news = 0;
  Wait(50.0);
  Decide();
  EXPECT_EQ(tracks_.objects[1].verdict.share, -1.0);
  Wait(20.0);
  Decide();
  EXPECT_GT(tracks_.objects[1].verdict.share, 0.98);
}

TEST_F(IdentityDecisionsTest, AtTheEndATieIsForGood) {
  SeeTwice(kKnown, kKnown, 0.1);
  Wait(kOutOfViewSeconds + 0.01);
  Decide();
  Conclude();
  ASSERT_EQ(tracks_.objects.size(), 1U);
  EXPECT_TRUE(tracks_.objects[0].is_landmark());
  EXPECT_EQ(CountBoxes(), 6U);
  EXPECT_EQ(tracks_.objects[0].sightings.hits, 6);
}

TEST_F(IdentityDecisionsTest, AtTheEndWhatIsStillInViewIsDecidedAsWell) {
  SeeTwice(kKnown, kKnown, 0.1);
  Conclude();
  EXPECT_EQ(tracks_.objects.size(), 1U);
  EXPECT_EQ(CountBoxes(), 6U);
}

TEST_F(IdentityDecisionsTest, OfManyInDoubtOnlySoManyStayOpen) {
  for (int i = 0; i < 14; ++i) {
    const Eigen::Vector3d p_W(4.0 + 6.0 * i, 1.0, kDepth);
    Mapped(p_W, FlyOver(p_W), InDoubt{});
  }
  Wait(kOutOfViewSeconds + 0.01);
  Decide();
  EXPECT_LE(std::ranges::count_if(tracks_.objects,
                                  [](const TrackedObject& o) { return o.Is<InDoubt>(); }),
            10);
}

TEST_F(IdentityDecisionsTest, AWrongTieIsTakenBackWhenItsTrackIsSeenElsewhere) {
  SeeTwice(kKnown, kKnown, 0.5);
  terms_.Tie(tracks_.objects[1], tracks_.objects[0]);
  Solve();
  // Frames that show both: they are two.
  for (const int node : FlyOver(kKnown)) {
    for (TrackedObject* object : {&tracks_.objects[0], &tracks_.objects[1]}) {
      Observation one = See(object->p_W, node);
      terms_.AddTerms(*object, one, false);
      object->observations.Add(std::move(one));
    }
  }
  ++tracks_.identity_news;
  Solve();
  Wait(kOutOfViewSeconds + 0.01);
  Decide();
  EXPECT_FALSE(tracks_.objects[1].Is<Tied>());
}

/// A row of objects, some of which a second visit shows again, and some of which are new then.
class RandomVisits : public IdentityDecisionsTest, public ::testing::WithParamInterface<int> {
 protected:
  void Visit() {
    Random random(static_cast<std::uint64_t>(GetParam()), "visits");
    for (int i = 0; i < 5; ++i) {
      const Eigen::Vector3d p_W(4.0 + 4.0 * i, random.Uniform(-0.5, 0.5), kDepth);
      const bool is_known = random.Chance(0.7);
      if (is_known) Mapped(p_W, FlyOver(p_W), Confirmed{});
      places_.push_back(p_W);
      is_known_.push_back(is_known);
    }
    FlyTo(40.0, 0.0, 0.15);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (!is_known_[i] || random.Chance(0.6)) Mapped(places_[i], FlyOver(places_[i]), InDoubt{});
    }
    for (TrackedObject& object : tracks_.objects)
      object.drift_sd = 0.2;
    boxes_ = CountBoxes();
    Wait(kOutOfViewSeconds + 0.01);
  }
  std::vector<Eigen::Vector3d> places_;
  std::vector<bool> is_known_;
  std::size_t boxes_ = 0;
};

TEST_P(RandomVisits, EndWithOneLandmarkPerObjectAndNoBoxLost) {
  Visit();
  Decide();
  EXPECT_EQ(CountBoxes(), boxes_);
  Conclude();
  EXPECT_EQ(CountBoxes(), boxes_);
  EXPECT_EQ(CountLandmarks(), places_.size());
  for (const Eigen::Vector3d& p_W : places_) {
    EXPECT_EQ(std::ranges::count_if(tracks_.objects,
                                    [&](const TrackedObject& o) {
                                      return o.is_landmark() && (o.p_W - p_W).norm() < 0.3;
                                    }),
              1);
  }
}

TEST_P(RandomVisits, NothingIsEverTiedToItselfOrToWhatIsNotThere) {
  Visit();
  for (int round = 0; round < 3; ++round) {
    Decide();
    for (const TrackedObject& object : tracks_.objects) {
      const std::optional<int> to = object.tied_to();
      if (!to) continue;
      EXPECT_LT(*to, object.id()) << "a track is taken for an older one";
      const TrackedObject* target = tracks_.FindById(*to);
      ASSERT_NE(target, nullptr);
      EXPECT_TRUE(target->is_mapped());
    }
    Wait(70.0);
  }
}

TEST_P(RandomVisits, EveryVerdictIsAShare) {
  Visit();
  Decide();
  for (const TrackedObject& object : tracks_.objects) {
    EXPECT_GE(object.verdict.share, 0.0);
    EXPECT_LE(object.verdict.share, 1.0 + 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomVisits, ::testing::Range(1, 11));

}  // namespace
}  // namespace limpet
