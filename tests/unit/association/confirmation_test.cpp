// SPDX-License-Identifier: MIT
// What it takes for boxes to be an object, and for an object to be a known one.
#include "estimation/association/confirmation.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/association/tracks_fixture.hpp"

namespace limpet {
namespace {

const Eigen::Vector3d kHere(4.0, 1.0, 6.0);

class ConfirmationTest : public TracksFixture {
 protected:
  void Confirm() {
    Confirmation(smoother_, params_, tracks_, terms_).ConfirmWhatIsDue(Newest());
    Solve();
  }
  /// True if the only track there is becomes an object.
  bool IsConfirmed() {
    Confirm();
    return tracks_.objects.size() == 1 && tracks_.objects[0].is_landmark();
  }
  TrackedObject& ThreeBoxes(double confidence = 0.85) {
    return Track(kHere, FlyOver(kHere), confidence);
  }
};

TEST_F(ConfirmationTest, ThreeBoxesAreAnObjectAndTwoAreNot) {
  const std::vector<int> nodes = FlyOver(kHere);
  Track(kHere, {nodes[0], nodes[2]});
  EXPECT_FALSE(IsConfirmed());
  tracks_.objects.clear();
  Track(kHere, nodes);
  EXPECT_TRUE(IsConfirmed());
  EXPECT_LT((tracks_.objects[0].p_W - kHere).norm(), 0.1);
  EXPECT_EQ(tracks_.objects[0].id(), 1);
}

TEST_F(ConfirmationTest, TheirConfidencesMustReachTheLogOddsTogether) {
  const auto of_each = [&](double log_odds) { return 1.0 / (1.0 + std::exp(-log_odds / 3.0)); };
  ThreeBoxes(of_each(params_.confirm_log_odds - 1e-6));
  EXPECT_FALSE(IsConfirmed());
  tracks_.objects.clear();
  ThreeBoxes(of_each(params_.confirm_log_odds + 1e-6));
  EXPECT_TRUE(IsConfirmed());
}

TEST_F(ConfirmationTest, AnObjectShowsInAQuarterOfTheFramesThatShouldShowIt) {
  ThreeBoxes().sightings.expected = 13;
  EXPECT_FALSE(IsConfirmed());
  tracks_.objects[0].sightings.expected = 12;
  EXPECT_TRUE(IsConfirmed());
}

TEST_F(ConfirmationTest, WhatIsMissedMoreOftenThanSeenMustBeSeenMoreSurely) {
  // Two frames in three do not show it: that costs 1.5 ln(7 / 4).
  const double needed = params_.confirm_log_odds + 1.5 * std::log(7.0 / 4.0);
  const auto of_each = [&](double log_odds) { return 1.0 / (1.0 + std::exp(-log_odds / 3.0)); };
  ThreeBoxes(of_each(needed - 1e-6)).sightings.expected = 9;
  EXPECT_FALSE(IsConfirmed());
  tracks_.objects.clear();
  ThreeBoxes(of_each(needed + 1e-6)).sightings.expected = 9;
  EXPECT_TRUE(IsConfirmed());
}

TEST_F(ConfirmationTest, BoxesBeyondThoseThatMakeAnObjectAreWorthLessEach) {
  // What makes a detector take a thing for an object once makes it do so again: six boxes that each
  // correlate by 0.2 with the others are worth 1.4 / 2 of six.
  std::vector<int> nodes = FlyOver(kHere);
  for (const int node : FlyOver(kHere))
    nodes.push_back(node);
  const auto of_each = [&](double log_odds) {
    return 1.0 / (1.0 + std::exp(-log_odds / 6.0 / 0.7));
  };
  Track(kHere, nodes, of_each(params_.confirm_log_odds - 1e-6));
  EXPECT_FALSE(IsConfirmed());
  tracks_.objects.clear();
  Track(kHere, nodes, of_each(params_.confirm_log_odds + 1e-6));
  EXPECT_TRUE(IsConfirmed());
}

TEST_F(ConfirmationTest, WhatMayJustBeAKnownObjectIsInDoubtAndWhatLiesBeyondIsNew) {
  // Places known to 0.3 m and 0.1 m more: 0.32 m together. Four of those are the gate.
  for (const double distance : {1.20, 1.40}) {
    tracks_.objects.clear();
    const Eigen::Vector3d known = kHere + Eigen::Vector3d(10.0 * distance, 0.0, 0.0);
    const Eigen::Vector3d beside = known + Eigen::Vector3d(0.0, distance, 0.0);
    Mapped(known, FlyOver(known), Confirmed{});
    TrackedObject& object = Track(beside, FlyOver(beside));
    Tentative place = object.tentative();
    place.covariance_W = 0.09 * Eigen::Matrix3d::Identity();
    object.state = place;
    Confirm();
    ASSERT_EQ(tracks_.objects.size(), 2U);
    EXPECT_EQ(tracks_.objects[1].Is<InDoubt>(), distance < 1.3) << distance;
    EXPECT_EQ(tracks_.objects[1].is_landmark(), distance > 1.3) << distance;
  }
}

TEST_F(ConfirmationTest, BoxesTooLongAgoDoNotCount) {
  const TrackedObject& object = ThreeBoxes();
  tracks_.now = object.observations.front().t + params_.confirm_within_s + 0.001;
  EXPECT_FALSE(IsConfirmed());
  tracks_.now -= 0.002;
  EXPECT_TRUE(IsConfirmed());
}

TEST_F(ConfirmationTest, BoxesThatDoNotAgreeOnAPlaceAreNoObject) {
  TrackedObject& object = ThreeBoxes();
  Tentative place = object.tentative();
  place.worst_residual = params_.confirm_residual + 1e-6;
  object.state = place;
  EXPECT_FALSE(IsConfirmed());
  place.worst_residual = params_.confirm_residual - 1e-6;
  tracks_.objects[0].state = place;
  EXPECT_TRUE(IsConfirmed());
}

TEST_F(ConfirmationTest, AnObjectWhosePlaceIsTooUncertainWaits) {
  TrackedObject& object = ThreeBoxes();
  Tentative place = object.tentative();
  place.covariance_W(1, 1) = std::pow(params_.confirm_sd_m + 1e-6, 2);
  object.state = place;
  EXPECT_FALSE(IsConfirmed());
  place.covariance_W(1, 1) = std::pow(params_.confirm_sd_m - 1e-6, 2);
  tracks_.objects[0].state = place;
  EXPECT_TRUE(IsConfirmed());
}

TEST_F(ConfirmationTest, TwoBoxesTellAnObjectThatIsKnownThere) {
  const std::vector<int> nodes = FlyOver(kHere);
  Mapped(kHere, nodes, Confirmed{});
  const std::vector<int> again = FlyOver(kHere);
  Track(kHere, {again[0], again[1]});
  Confirm();
  ASSERT_EQ(tracks_.objects.size(), 1U);
  EXPECT_EQ(tracks_.objects[0].observations.size(), 5U);
  EXPECT_EQ(tracks_.objects[0].sightings.hits, 5);
  EXPECT_EQ(CountBoxes(), 5U);
}

TEST_F(ConfirmationTest, ADifferentPlaceIsAnotherObject) {
  Mapped(kHere, FlyOver(kHere), Confirmed{});
  const Eigen::Vector3d there = kHere + Eigen::Vector3d(0.0, 2.0, 0.0);
  Track(there, FlyOver(there));
  Confirm();
  EXPECT_EQ(CountLandmarks(), 2U);
  EXPECT_EQ(CountBoxes(), 6U);
}

TEST_F(ConfirmationTest, WhatWasSeenBesideAKnownObjectIsAnotherOneHoweverNear) {
  const std::vector<int> nodes = FlyOver(kHere);
  const Eigen::Vector3d beside = kHere + Eigen::Vector3d(0.0, 0.3, 0.0);
  Mapped(kHere, nodes, Confirmed{});
  Track(beside, nodes);
  Confirm();
  EXPECT_EQ(CountLandmarks(), 2U);
}

TEST_F(ConfirmationTest, WhereThePoseHasDriftedWhatMayBeKnownIsLeftInDoubt) {
  Mapped(kHere, FlyOver(kHere), Confirmed{});
  FlyTo(30.0, 0.0, 0.5);
  Track(kHere, FlyOver(kHere, 0.5));
  Confirm();
  ASSERT_EQ(tracks_.objects.size(), 2U);
  EXPECT_TRUE(tracks_.objects[1].Is<InDoubt>());
  EXPECT_GT(tracks_.objects[1].drift_sd, params_.small_drift_m);
}

TEST_F(ConfirmationTest, WhileATieMayBeWrongNothingIsTakenForCertain) {
  ThreeBoxes();
  tracks_.is_provisional = true;
  Confirm();
  ASSERT_EQ(tracks_.objects.size(), 1U);
  EXPECT_TRUE(tracks_.objects[0].Is<InDoubt>());
}

TEST_F(ConfirmationTest, ManyObjectsAtOnceAreAllConfirmedUnderDifferentIds) {
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < 6; ++i)
    places.emplace_back(4.0 + 5.0 * i, 1.0, kDepth);
  for (const Eigen::Vector3d& p_W : places)
    Track(p_W, FlyOver(p_W));
  Confirm();
  EXPECT_EQ(CountLandmarks(), places.size());
  std::set<int> ids;
  for (const TrackedObject& object : tracks_.objects)
    EXPECT_TRUE(ids.insert(object.id()).second);
}

}  // namespace
}  // namespace limpet
