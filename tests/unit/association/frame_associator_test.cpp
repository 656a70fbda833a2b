// SPDX-License-Identifier: MIT
// Which track a box is assigned to, and when to none.
#include "estimation/association/frame_associator.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/association/tracks_fixture.hpp"

namespace limpet {
namespace {

const Eigen::Vector3d kThere(4.0, 1.0, 6.0);

class FrameAssociatorTest : public TracksFixture {
 protected:
  /// Of a box that shows a sphere there from the newest pose.
  [[nodiscard]] Candidate Shown(const Eigen::Vector3d& p_W) const {
    Box box = *BoxFrom(camera_, truth_.back(), p_W);
    return {.detection = 0, .seen = {box, ReadBox(box, camera_, params_.model.noise)}};
  }
  [[nodiscard]] std::vector<Association> Assign(const std::vector<Candidate>& candidates,
                                                double path = 0.0) const {
    const int node = static_cast<int>(truth_.size()) - 1;
    return FrameAssociator(smoother_, mount_, params_, tracks_)
        .Assign({.x = smoother_.PoseAt(node), .node = node, .path = path}, candidates);
  }
  /// -2 ln of the likelihood ratio of a box being a landmark's, against being something new.
  [[nodiscard]] double CostOf(const Candidate& candidate, const TrackedObject& landmark) const {
    const NavVector x = smoother_.PoseAt(static_cast<int>(truth_.size()) - 1);
    ExpectedObject expected;
    expected.p_W = landmark.p_W;
    expected.radius = params_.model.radius_m * std::exp(landmark.log_size);
    expected.color = landmark.color();
    expected.covariance = smoother_.Covariance({landmark.slot()});
    const auto match = BoxGate(camera_, params_.gate).Match(candidate.seen, x, expected);
    return match ? match->cost - match->new_cost : 0.0;
  }
  [[nodiscard]] Association::Kind KindOf(const Eigen::Vector3d& p_W, double path = 0.0) const {
    return Assign({Shown(p_W)}, path)[0].kind;
  }
};

TEST_F(FrameAssociatorTest, ABoxWhereALandmarkIsExpectedIsOfIt) {
  Mapped(kThere, FlyOver(kThere), Confirmed{});
  EXPECT_EQ(KindOf(kThere), Association::Kind::kTrack);
  EXPECT_EQ(KindOf(kThere + Eigen::Vector3d(0.0, 1.4, 0.0)), Association::Kind::kNothing);
}

TEST_F(FrameAssociatorTest, WithoutTracksEveryBoxIsNew) {
  FlyTo(4.0, 1.0);
  EXPECT_EQ(KindOf(kThere), Association::Kind::kNothing);
  EXPECT_TRUE(Assign({}).empty());
}

TEST_F(FrameAssociatorTest, TwoBoxesAreOfTwoLandmarksEachItsOwn) {
  const Eigen::Vector3d other = kThere + Eigen::Vector3d(0.0, 1.2, 0.0);
  const std::vector<int> nodes = FlyOver(kThere);
  Mapped(kThere, nodes, Confirmed{});
  Mapped(other, nodes, Confirmed{});
  const auto forth = Assign({Shown(kThere), Shown(other)});
  EXPECT_EQ(forth[0].track, 0U);
  EXPECT_EQ(forth[1].track, 1U);
  const auto back = Assign({Shown(other), Shown(kThere)});
  EXPECT_EQ(back[0].track, 1U);
  EXPECT_EQ(back[1].track, 0U);
}

TEST_F(FrameAssociatorTest, ABoxBetweenTwoThatItFitsAlikeIsLeftOutRatherThanGuessed) {
  const Eigen::Vector3d off(0.0, 0.06, 0.0);
  const std::vector<int> nodes = FlyOver(kThere);
  Mapped(kThere - off, nodes, Confirmed{});
  Mapped(kThere + off, nodes, Confirmed{});
  EXPECT_EQ(KindOf(kThere), Association::Kind::kAmbiguous);
  // Both there: each is its own, and neither is anybody's rival.
  const auto both = Assign({Shown(kThere - off), Shown(kThere + off)});
  EXPECT_EQ(both[0].kind, Association::Kind::kTrack);
  EXPECT_EQ(both[1].kind, Association::Kind::kTrack);
}

TEST_F(FrameAssociatorTest, ItIsGuessedOnlyWhereOneIsLikelierByAFactorOfE) {
  const Eigen::Vector3d off(0.0, 0.1, 0.0);
  const std::vector<int> nodes = FlyOver(kThere);
  Mapped(kThere - off, nodes, Confirmed{});
  Mapped(kThere + off, nodes, Confirmed{});
  int ambiguous = 0, guessed = 0;
  for (double share = 0.0; share < 1.0; share += 0.02) {
    const Candidate box = Shown(kThere + share * off);
    const double apart = CostOf(box, tracks_.objects[0]) - CostOf(box, tracks_.objects[1]);
    if (std::abs(apart - 2.0) < 0.05) continue;
    const bool is_guessed = Assign({box})[0].kind == Association::Kind::kTrack;
    EXPECT_EQ(is_guessed, apart > 2.0) << share;
    (is_guessed ? guessed : ambiguous) += 1;
  }
  EXPECT_GT(ambiguous, 2);
  EXPECT_GT(guessed, 2);
}

TEST_F(FrameAssociatorTest, ALandmarkThatWasNotSeenForLongMustFitBetterThanOneInSight) {
  Mapped(kThere, FlyOver(kThere), Confirmed{});
  int taken = 0, left = 0;
  for (double off = 0.0; off < 1.5; off += 0.02) {
    const Candidate box = Shown(kThere + Eigen::Vector3d(0.0, off, 0.0));
    const double cost = CostOf(box, tracks_.objects[0]);
    tracks_.now = 3.0;
    EXPECT_EQ(Assign({box})[0].kind == Association::Kind::kTrack, cost < 0.0) << off;
    tracks_.now = 3.0 + params_.confirm_within_s;
    if (std::abs(cost + 4.0) < 0.05) continue;
    const bool is_taken = Assign({box})[0].kind == Association::Kind::kTrack;
    EXPECT_EQ(is_taken, cost < -4.0) << off;
    (is_taken ? taken : left) += 1;
  }
  EXPECT_GT(taken, 2);
  EXPECT_GT(left, 2);
}

TEST_F(FrameAssociatorTest, AnExpectationOf25PixelsIsGoodForTheSmallestBox) {
  params_.model.radius_m = 0.2;
  const auto small = [&](const Eigen::Vector3d& p_W) {
    const Eigen::Vector3d p_C = CameraPointOf(camera_, truth_.back(), p_W).p_C;
    Box box = *BoxOfSphere(p_C, 0.2, camera_);
    box.confidence = 0.85, box.color = "yellow";
    return box;
  };
  TrackedObject object;
  for (const double ahead : {-0.5, 0.0, 0.5}) {
    const int node = FlyTo(kThere.x() + ahead, kThere.y());
    object.observations.Add(ObservationOf(small(kThere), camera_, node, node));
  }
  object.sightings.max_distance = 4.0;
  Place(object, smoother_, mount_, params_.model);
  tracks_.objects.push_back(object);
  terms_.Map(tracks_.objects.back(), Confirmed{});
  Solve();
  for (const double sigma : {0.1, 0.3}) {  // 13 and 38 pixels at 3 m; the box has 51
    FlyTo(kThere.x(), kThere.y(), sigma);
    const Box box = small(kThere);
    const auto kind =
        Assign({{.detection = 0, .seen = {box, ReadBox(box, camera_, params_.model.noise)}}})[0]
            .kind;
    EXPECT_EQ(kind, sigma < 0.2 ? Association::Kind::kTrack : Association::Kind::kNothing) << sigma;
  }
}

TEST_F(FrameAssociatorTest, ALandmarkIsNotLookedForFarBeyondWhereItWasEverSeenFrom) {
  TrackedObject& landmark = Mapped(kThere, FlyOver(kThere), Confirmed{});
  FlyTo(4.0, 1.0);  // 3 m above it
  // Three metres more than that, and what the pose may be off.
  landmark.sightings.max_distance = 0.02;
  EXPECT_EQ(KindOf(kThere), Association::Kind::kTrack);
  landmark.sightings.max_distance = -0.3;
  EXPECT_EQ(KindOf(kThere), Association::Kind::kNothing);
}

TEST_F(FrameAssociatorTest, WhereThePoseIsTooUncertainOneBoxAloneDecidesNothing) {
  Mapped(kThere, FlyOver(kThere), Confirmed{});
  FlyTo(4.0, 1.0, 0.05);
  EXPECT_EQ(KindOf(kThere), Association::Kind::kTrack);
  FlyTo(4.0, 1.0, 0.5);
  EXPECT_EQ(KindOf(kThere), Association::Kind::kNothing);
}

TEST_F(FrameAssociatorTest, ATentativeObjectIsFoundAgainUnlessTheVehicleHasGoneFarSince) {
  Track(kThere, FlyOver(kThere)).sightings.last_path = 10.0;
  const Eigen::Vector3d off = kThere + Eigen::Vector3d(0.0, 0.15, 0.0);
  EXPECT_EQ(KindOf(off, 10.0), Association::Kind::kTrack);
  // Nearly a metre off is too far at once; after fifty metres it may well be drift.
  const Eigen::Vector3d far = kThere + Eigen::Vector3d(0.0, 0.9, 0.0);
  EXPECT_EQ(KindOf(far, 10.0), Association::Kind::kNothing);
  EXPECT_EQ(KindOf(far, 60.0), Association::Kind::kTrack);
}

}  // namespace
}  // namespace limpet
