// SPDX-License-Identifier: MIT
#include "estimation/association/landmark_review.hpp"

#include <cmath>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "tests/unit/association/tracks_fixture.hpp"

namespace limpet {
namespace {

const Eigen::Vector3d kOne(4.0, 1.0, 6.0);

class LandmarkReviewTest : public TracksFixture {
 protected:
  /// A landmark of a pass back and forth over it.
  TrackedObject& LandmarkAt(const Eigen::Vector3d& p_W) {
    std::vector<int> nodes = FlyOver(p_W);
    for (const int node : FlyOver(p_W))
      nodes.push_back(node);
    return Mapped(p_W, nodes, Confirmed{});
  }
  /// A box of something else that was taken for the track's.
  void Mistake(TrackedObject& object, const Eigen::Vector3d& p_W, int node) {
    Observation one = See(p_W, node);
    terms_.AddTerms(object, one, false);
    object.observations.Add(std::move(one));
    object.review.is_due = true;
    Solve();
  }
  LandmarkReview review_{smoother_, mount_, params_, tracks_, terms_};
};

TEST_F(LandmarkReviewTest, BoxesThatFitStay) {
  LandmarkAt(kOne);
  EXPECT_FALSE(review_.RemoveOutliers());
  EXPECT_EQ(review_.rejected(), 0);
  EXPECT_EQ(CountBoxes(), 6U);
}

TEST_F(LandmarkReviewTest, ABoxOfSomethingElseIsTakenOutAndPullsNoMore) {
  TrackedObject& object = LandmarkAt(kOne);
  Mistake(object, kOne + Eigen::Vector3d(0.0, 1.2, 0.0), 2);
  const double pulled = (object.p_W - kOne).norm();
  EXPECT_TRUE(review_.RemoveOutliers());
  Solve();
  EXPECT_EQ(review_.rejected(), 1);
  EXPECT_EQ(tracks_.objects.size(), 1U);
  EXPECT_EQ(CountBoxes(), 6U);
  EXPECT_LT((tracks_.objects[0].p_W - kOne).norm(), pulled);
  EXPECT_LT((tracks_.objects[0].p_W - kOne).norm(), 0.02);
}

TEST_F(LandmarkReviewTest, OutliersThatAgreeAreAnotherObjectAfterAll) {
  TrackedObject& object = LandmarkAt(kOne);
  const Eigen::Vector3d other = kOne + Eigen::Vector3d(0.0, 1.3, 0.0);
  for (const int node : {0, 1, 2})
    Mistake(object, other, node);
  ASSERT_TRUE(review_.RemoveOutliers());
  Solve();
  ASSERT_EQ(tracks_.objects.size(), 2U);
  EXPECT_TRUE(tracks_.objects[1].Is<InDoubt>()) << "what it is, is to be decided";
  EXPECT_LT((tracks_.objects[1].p_W - other).norm(), 0.3);
  EXPECT_EQ(tracks_.objects[1].drift_sd, 0.5) << "so much was it mistaken by at most";
  EXPECT_EQ(CountBoxes(), 9U);
}

TEST_F(LandmarkReviewTest, WhatWasReviewedIsNotReviewedAgainBeforeItIsSeenAgain) {
  TrackedObject& object = LandmarkAt(kOne);
  EXPECT_FALSE(review_.RemoveOutliers());
  Mistake(object, kOne + Eigen::Vector3d(0.0, 1.2, 0.0), 2);
  object.review.is_due = false;
  EXPECT_FALSE(review_.RemoveOutliers());
  object.review.is_due = true;
  EXPECT_TRUE(review_.RemoveOutliers());
}

struct OldBox {
  double last_seen;  ///< of the landmark, whose wrong box came at 2 s
  double moved;      ///< since it was reviewed [m]
  bool is_found;
};
class OldBoxes : public LandmarkReviewTest, public ::testing::WithParamInterface<OldBox> {};

TEST_P(OldBoxes, AreReviewedAgainOnceTheLandmarkHasMovedTenCentimetres) {
  const auto& [last_seen, moved, is_found] = GetParam();
  TrackedObject& object = LandmarkAt(kOne);
  Mistake(object, kOne + Eigen::Vector3d(0.0, 1.2, 0.0), 2);
  Observation late = See(kOne, 5);
  late.t = last_seen;
  terms_.AddTerms(object, late, false);
  object.observations.Add(std::move(late));
  Solve();
  object.review.p_W = object.p_W + Eigen::Vector3d(moved, 0.0, 0.0);
  object.review.is_due = true;
  EXPECT_EQ(review_.RemoveOutliers(), is_found);
}

INSTANTIATE_TEST_SUITE_P(Borders, OldBoxes,
                         ::testing::Values(OldBox{40.0, 0.09, false}, OldBox{40.0, 0.11, true},
                                           OldBox{32.1, 0.0, false}, OldBox{31.9, 0.0, true}));

TEST_F(LandmarkReviewTest, TwoThatAreLikelyOneAreInDoubtByWhatTheirDifferenceIsUnsure) {
  LandmarkAt(kOne);
  LandmarkAt(kOne);
  const Eigen::MatrixXd joint =
      smoother_.Covariance({tracks_.objects[0].slot(), tracks_.objects[1].slot()});
  const Eigen::Matrix3d S = joint.block<3, 3>(6, 6) + joint.block<3, 3>(9, 9) -
                            joint.block<3, 3>(6, 9) - joint.block<3, 3>(9, 6);
  review_.DoubtDuplicates();
  // Five centimetres between two places of one object are nobody's.
  const double expected = std::sqrt(S.diagonal().head<2>().maxCoeff() + 0.05 * 0.05);
  EXPECT_NEAR(tracks_.objects[1].drift_sd, expected, 1e-9);
}

TEST_F(LandmarkReviewTest, ALandmarkThatFortyFramesHardlyShowIsGivenUp) {
  for (const auto& [expected, hits, stays] :
       {std::tuple(39, 0, true), std::tuple(40, 3, false), std::tuple(40, 4, true),
        std::tuple(100, 9, false), std::tuple(100, 10, true)}) {
    TrackedObject& object = LandmarkAt(kOne);
    object.sightings.expected = expected, object.sightings.hits = hits;
    EXPECT_EQ(review_.DropFalseLandmarks(), !stays) << hits << " of " << expected;
    EXPECT_EQ(CountLandmarks(), stays ? 1U : 0U) << hits << " of " << expected;
    tracks_.objects.clear();
  }
}

TEST_F(LandmarkReviewTest, ATrackThatIsTakenForAFalseLandmarkIsInDoubtAgain) {
  LandmarkAt(kOne);
  Mapped(kOne, FlyOver(kOne), InDoubt{});
  terms_.Tie(tracks_.objects[1], tracks_.objects[0]);
  tracks_.objects[0].sightings.expected = 100;
  EXPECT_TRUE(review_.DropFalseLandmarks());
  ASSERT_EQ(tracks_.objects.size(), 1U);
  EXPECT_TRUE(tracks_.objects[0].Is<InDoubt>());
}

TEST_F(LandmarkReviewTest, TwoLandmarksAtOnePlaceAreLikelyOneAndTheYoungerIsInDoubt) {
  LandmarkAt(kOne);
  LandmarkAt(kOne);
  review_.DoubtDuplicates();
  EXPECT_TRUE(tracks_.objects[0].is_landmark());
  EXPECT_TRUE(tracks_.objects[1].Is<InDoubt>());
  EXPECT_EQ(tracks_.identity_news, 1);
}

TEST_F(LandmarkReviewTest, TwoLandmarksAtOnePlaceAreTwoIfFramesShowedBoth) {
  std::vector<int> nodes = FlyOver(kOne);
  Mapped(kOne, nodes, Confirmed{});
  Mapped(kOne + Eigen::Vector3d(0.0, 0.2, 0.0), nodes, Confirmed{});
  review_.DoubtDuplicates();
  EXPECT_EQ(CountLandmarks(), 2U);
}

TEST_F(LandmarkReviewTest, LandmarksThatAreClearlyApartAreNotDoubted) {
  LandmarkAt(kOne);
  LandmarkAt(kOne + Eigen::Vector3d(0.0, 1.5, 0.0));
  LandmarkAt(kOne + Eigen::Vector3d(3.0, 0.0, 0.0));
  review_.DoubtDuplicates();
  EXPECT_EQ(CountLandmarks(), 3U);
}

TEST_F(LandmarkReviewTest, LandmarksFurtherApartThanTheReachAreNeverOneHoweverUncertain) {
  LandmarkAt(kOne);
  FlyTo(40.0, 0.0, 5.0);
  LandmarkAt(kOne + Eigen::Vector3d(params_.merge_distance_m + 0.1, 0.0, 0.0));
  review_.DoubtDuplicates();
  EXPECT_EQ(CountLandmarks(), 2U);
}

class LandmarkTermsTest : public TracksFixture {};

TEST_F(LandmarkTermsTest, NoIdIsEverGivenTwice) {
  std::set<int> ids;
  for (int i = 0; i < 5; ++i) {
    TrackedObject& object = Mapped(kOne, FlyOver(kOne), Confirmed{});
    EXPECT_TRUE(ids.insert(object.id()).second);
    if (i % 2 == 0) terms_.Remove(object);
    tracks_.EraseEmpty();
  }
}

TEST_F(LandmarkTermsTest, ATieHoldsTwoTracksTogetherAndIsGoneWhenItIsReleased) {
  const Eigen::Vector3d apart = kOne + Eigen::Vector3d(0.0, 0.6, 0.0);
  Mapped(kOne, FlyOver(kOne), Confirmed{});
  Mapped(apart, FlyOver(apart), InDoubt{});
  const auto distance = [&] {
    Solve();
    return (tracks_.objects[0].p_W - tracks_.objects[1].p_W).norm();
  };
  const double free = distance();
  terms_.Tie(tracks_.objects[1], tracks_.objects[0]);
  EXPECT_LT(distance(), 0.5 * free);
  terms_.Release(tracks_.objects[1]);
  EXPECT_TRUE(tracks_.objects[1].Is<InDoubt>());
  EXPECT_NEAR(distance(), free, 0.02);
}

TEST_F(LandmarkTermsTest, AnAbsorbedTrackLeavesAllItsBoxesAndCountsAndNothingElse) {
  Mapped(kOne, FlyOver(kOne), Confirmed{});
  Mapped(kOne, FlyOver(kOne), InDoubt{});
  Mapped(kOne, FlyOver(kOne), InDoubt{});
  terms_.Tie(tracks_.objects[1], tracks_.objects[0]);
  terms_.Tie(tracks_.objects[2], tracks_.objects[1]);
  terms_.Absorb(tracks_.objects[1]);
  EXPECT_TRUE(tracks_.objects[2].IsTiedTo(tracks_.objects[0].id()))
      << "what was tied to it is now tied to what absorbed it";
  tracks_.EraseEmpty();
  ASSERT_EQ(tracks_.objects.size(), 2U);
  EXPECT_EQ(tracks_.objects[0].observations.size(), 6U);
  EXPECT_EQ(tracks_.objects[0].sightings.hits, 6);
  EXPECT_TRUE(std::ranges::is_sorted(tracks_.objects[0].observations, {}, &Observation::frame));
  EXPECT_EQ(CountBoxes(), 9U);
  EXPECT_TRUE(terms_.RemoveAbsorbed(true));
  EXPECT_FALSE(terms_.RemoveAbsorbed(true)) << "nothing is left of it";
}

TEST_F(LandmarkTermsTest, TheBoxesOfAMergedTrackMakeTheLandmarkSurer) {
  const auto variance = [this](const TrackedObject& object) {
    return smoother_.Covariance({object.slot()}).bottomRightCorner<3, 3>().trace();
  };
  const double before = variance(Mapped(kOne, FlyOver(kOne), Confirmed{}));
  Track(kOne, FlyOver(kOne));
  terms_.MergeTentative(tracks_.objects[1], tracks_.objects[0]);
  tracks_.EraseEmpty();
  Solve();
  ASSERT_EQ(tracks_.objects.size(), 1U);
  EXPECT_LT(variance(tracks_.objects[0]), before);
}

class TrackPlacementTest : public TracksFixture {};

TEST_F(TrackPlacementTest, AnOldestBoxThatPutsTheObjectIntoTheGroundWasOfSomethingElse) {
  const std::vector<int> nodes = FlyOver(kOne);
  TrackedObject object;
  for (const int node : nodes) {
    Observation one = See(kOne, node);
    one.altitude = 1.9;  // the object would be 1.1 m below the seabed
    object.observations.Add(std::move(one));
  }
  Place(object, smoother_, mount_, params_.model);
  EXPECT_EQ(object.observations.size(), 2U);
  EXPECT_EQ(object.observations.front().node, nodes[1]);
  EXPECT_EQ(object.sightings.hits, 2);
}

TEST_F(TrackPlacementTest, AnObjectOnTheSeabedKeepsItsBoxes) {
  TrackedObject object;
  for (const int node : FlyOver(kOne)) {
    Observation one = See(kOne, node);
    one.altitude = 3.9;
    object.observations.Add(std::move(one));
  }
  Place(object, smoother_, mount_, params_.model);
  EXPECT_EQ(object.observations.size(), 3U);
  EXPECT_LT((object.p_W - kOne).norm(), 0.01);
}

TEST_F(TrackPlacementTest, WhereObjectsComeInPairsANewOneIsLessOfASurprise) {
  EXPECT_NEAR(NewObjectCost(tracks_, params_), -2.0 * std::log(params_.objects_per_m3), 1e-9);
  Mapped(kOne, FlyOver(kOne), Confirmed{});
  const double alone = NewObjectCost(tracks_, params_);
  EXPECT_NEAR(alone, -2.0 * std::log(params_.objects_per_m3), 1e-9);
  const Eigen::Vector3d beside = kOne + Eigen::Vector3d(0.0, 1.5, 0.0);
  Mapped(beside, FlyOver(beside), Confirmed{});
  EXPECT_LT(NewObjectCost(tracks_, params_), alone - 2.0);
}

}  // namespace
}  // namespace limpet
