// SPDX-License-Identifier: MIT
// Which track a box is assigned to, and when to none.
#include "estimation/association/frame_associator.hpp"

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

TEST_F(FrameAssociatorTest, ALandmarkIsNotLookedForFarBeyondWhereItWasEverSeenFrom) {
  TrackedObject& landmark = Mapped(kThere, FlyOver(kThere), Confirmed{});
  FlyTo(4.0, 1.0);  // 3 m above it
  // Three metres more than that, and what the pose may be off.
  landmark.max_distance = 0.02;
  EXPECT_EQ(KindOf(kThere), Association::Kind::kTrack);
  landmark.max_distance = -0.3;
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
  Track(kThere, FlyOver(kThere)).last_path = 10.0;
  const Eigen::Vector3d off = kThere + Eigen::Vector3d(0.0, 0.15, 0.0);
  EXPECT_EQ(KindOf(off, 10.0), Association::Kind::kTrack);
  // Nearly a metre off is too far at once; after fifty metres it may well be drift.
  const Eigen::Vector3d far = kThere + Eigen::Vector3d(0.0, 0.9, 0.0);
  EXPECT_EQ(KindOf(far, 10.0), Association::Kind::kNothing);
  EXPECT_EQ(KindOf(far, 60.0), Association::Kind::kTrack);
}

}  // namespace
}  // namespace limpet
