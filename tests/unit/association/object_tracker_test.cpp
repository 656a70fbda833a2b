// SPDX-License-Identifier: MIT
#include "estimation/association/object_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/object_flight.hpp"

namespace limpet {
namespace {

class ObjectTrackerTest : public ::testing::Test, protected ObjectFlight {
 protected:
  /// Flies to (north, east); `drift_east` is added to what odometry says of the way [m].
  void FlyTo(double north, double east, double drift_east = 0.0) {
    ObjectFlight::FlyTo({north, east}, {0.0, drift_east});
  }
};

TEST_F(ObjectTrackerTest, FindsAnObjectWhereItIs) {
  objects_ = {{5.0, 0.5, 6.5}};
  FlyTo(10.0, 0.0);
  ASSERT_EQ(Found().size(), 1U);
  EXPECT_LT((Found()[0].p_W - objects_[0]).norm(), 0.15);
}

/// Believed to be half a metre, give or take a fifth.
class LargeObjectTest : public ::testing::Test, protected ObjectFlight {
 protected:
  static ObjectTrackerParams SizesInDoubt() {
    ObjectTrackerParams params;
    params.model.size_spread = kSizeSpread;
    return params;
  }
  LargeObjectTest() : ObjectFlight(3, 0.0, SizesInDoubt()) {
    radius_ = 1.0;
    objects_ = {{6.0, 1.2, 5.5}};  // 2 m below the camera, 1.2 m beside its way
  }
};

TEST_F(LargeObjectTest, ThatOnlyCornersOfImagesShowIsFoundWhereItIs) {
  int corners = 0, others = 0;
  for (int i = 1; i <= 12; ++i) {
    FlyTo({1.0 * i, 0.0});
    const auto box = BoxOfSphere(CameraPointOf(camera_, truth_, objects_[0]).p_C, radius_, camera_);
    if (!box) continue;
    const bool is_corner =
        ExtentAcross(*box, camera_).is_cut() && ExtentAlong(*box, camera_).is_cut();
    ++(is_corner ? corners : others);
  }
  ASSERT_GT(corners, 2);
  ASSERT_EQ(others, 0) << "no axis shows whole";
  ASSERT_EQ(Found().size(), 1U);
  EXPECT_LT((Found()[0].p_W - objects_[0]).norm(), 0.4);
}

TEST_F(ObjectTrackerTest, NamesTheLandmarkThatABoxShows) {
  objects_ = {{5.0, 0.5, 6.5}};
  FlyTo(5.0, 0.0);
  ASSERT_EQ(shown_.size(), 1U);
  EXPECT_EQ(shown_[0], Found()[0].id());
}

TEST_F(ObjectTrackerTest, TakesRandomFalseBoxesForNothing) {
  false_share_ = 0.1;
  for (int i = 0; i < 4; ++i) {
    FlyTo(20.0, 3.0 * i);
    FlyTo(0.0, 3.0 * i);
  }
  EXPECT_TRUE(Found().empty());
}

TEST_F(ObjectTrackerTest, TakesAThingThatIsSeldomAndHalfheartedlyTakenForAnObjectForNone) {
  objects_ = {{5.0, 0.5, 6.5}};
  hit_share_ = 0.4, confidence_ = 0.6;
  FlyTo(10.0, 0.0);
  EXPECT_TRUE(Found().empty());
}

TEST_F(ObjectTrackerTest, FindsAnObjectThatIsSeenHalfheartedlyButAlways) {
  objects_ = {{5.0, 0.5, 6.5}};
  confidence_ = 0.7;
  FlyTo(10.0, 0.0);
  EXPECT_EQ(Found().size(), 1U);
}

TEST_F(ObjectTrackerTest, KeepsTwoObjectsThatStandCloseTogetherApart) {
  objects_ = {{5.0, 0.0, 6.8}, {5.0, 1.2, 6.8}};
  FlyTo(10.0, 0.3);
  FlyTo(0.0, 0.6);
  ASSERT_EQ(Found().size(), 2U);
  EXPECT_NEAR((Found()[0].p_W - Found()[1].p_W).norm(), 1.2, 0.25);
}

TEST_F(ObjectTrackerTest, RecognisesAnObjectAfterALongWayRound) {
  objects_ = {{5.0, 0.5, 6.5}};
  FlyTo(10.0, 0.0);
  FlyTo(10.0, 15.0);
  FlyTo(5.0, 15.0);
  FlyTo(5.0, -3.0);
  ASSERT_EQ(Found().size(), 1U);
  EXPECT_EQ(Found()[0].id(), 1);
}

TEST_F(ObjectTrackerTest, RecognisesAnObjectAfterDriftThatOdometryAdmits) {
  objects_ = {{5.0, 0.5, 6.5}};
  step_sigma_ = 0.08;
  FlyTo(10.0, 0.0);
  FlyTo(10.0, 15.0, 0.6);
  FlyTo(5.0, 15.0);
  FlyTo(5.0, -3.0);
  ASSERT_EQ(Found().size(), 1U);
  EXPECT_LT((Found()[0].p_W - objects_[0]).norm(), 0.3);
}

TEST_F(ObjectTrackerTest, AnObjectWhoseFirstPassNamedTheWrongColourIsOneObjectOfTheRightColour) {
  objects_ = {{5.0, 0.5, 6.5}};
  step_sigma_ = 0.03;
  color_ = "orange";  // its dim side, in every image
  FlyTo(10.0, 0.0);
  ASSERT_EQ(Found().size(), 1U);
  color_ = "yellow";
  FlyTo(10.0, 15.0, 0.2);
  FlyTo(5.0, 15.0);
  FlyTo(5.0, -8.0);
  ASSERT_EQ(Found().size(), 1U);
  EXPECT_EQ(Found()[0].id(), 1);
  EXPECT_EQ(tracker_.BoxesOf(Found()[0]).color, "yellow") << "more boxes named it so";
  EXPECT_EQ(std::ranges::count_if(tracker_.objects(), &TrackedObject::Is<InDoubt>), 0);
}

TEST_F(ObjectTrackerTest, OneFalseBoxWhereADriftedObjectIsExpectedMovesNothing) {
  objects_ = {{5.0, 0.5, 6.5}};
  step_sigma_ = 0.08;
  FlyTo(10.0, 0.0);
  FlyTo(10.0, 15.0);
  FlyTo(5.0, 15.0);
  FlyTo(5.0, 4.0);
  objects_[0].y() = 2.0;  // one box, a metre and a half from where the object is
  FlyTo(5.0, 3.9);
  objects_.clear();
  const double before = smoother_.PoseAt(smoother_.graph().node_count() - 1).y();
  FlyTo(5.0, 3.4);
  EXPECT_NEAR(smoother_.PoseAt(smoother_.graph().node_count() - 1).y(), before - 0.5, 0.05);
}

TEST_F(ObjectTrackerTest, TellsWhichOfTwoLikeObjectsItSeesAgainAfterDrift) {
  objects_ = {{5.0, 0.0, 6.8}, {5.0, 1.2, 6.8}};
  step_sigma_ = 0.06;
  FlyTo(10.0, 0.6);
  FlyTo(10.0, 15.0, 0.5);
  FlyTo(0.0, 15.0);
  FlyTo(0.0, 0.6);
  FlyTo(10.0, 0.6);
  ASSERT_EQ(Found().size(), 2U);
  for (const Eigen::Vector3d& object : objects_) {
    const double off = std::min((Found()[0].p_W - object).norm(), (Found()[1].p_W - object).norm());
    EXPECT_LT(off, 0.35);
  }
}

TEST_F(ObjectTrackerTest, MergesADuplicateUnderTheOlderId) {
  objects_ = {{5.0, 0.5, 6.5}};
  FlyTo(10.0, 0.0);
  FlyTo(10.0, 15.0, 2.5);  // drift far beyond what the odometry admits
  FlyTo(5.0, 15.0);
  FlyTo(5.0, -3.0);
  EXPECT_GE(Found().size(), 1U);
  EXPECT_EQ(Found()[0].id(), 1);
}

/// One or two objects and, some way east, two more. After a way round with drift that odometry
/// admits, the vehicle comes to the first again, then to the others.
class SecondVisitTest : public ObjectTrackerTest {
 protected:
  void VisitAll(std::vector<Eigen::Vector3d> first) {
    first_ = std::move(first);
    objects_ = first_;
    objects_.insert(objects_.end(), others_.begin(), others_.end());
    FlyTo(5.0, -4.0);
    FlyTo(5.0, 16.0);
    objects_.clear();
    step_sigma_ = 0.05;
    FlyTo(20.0, 16.0);
    FlyTo(20.0, -4.0, -0.3);
    FlyTo(5.0, -4.0);
    step_sigma_ = 0.01;  // little drift between what is seen on the second visit
    known_ = Found().size();
  }
  void SeeAgain(const Eigen::Vector3d& object) {
    objects_ = {object};
    FlyTo(5.0, 6.5);
  }
  void SeeOthers() {
    objects_ = others_;
    FlyTo(5.0, 16.0);
  }
  int CountInDoubt() const {
    return static_cast<int>(std::ranges::count_if(
        tracker_.objects(), [](const TrackedObject& o) { return o.Is<InDoubt>(); }));
  }
  double NearestTo(const Eigen::Vector3d& place) const {
    double nearest = 99.0;
    for (const TrackedObject& object : Found())
      nearest = std::min(nearest, (object.p_W - place).norm());
    return nearest;
  }
  double PoseError() const {
    const int head = smoother_.graph().node_count() - 1;
    return (smoother_.PoseAt(head) - truth_).head<2>().norm();
  }
  std::vector<Eigen::Vector3d> first_;
  const std::vector<Eigen::Vector3d> others_{{5.0, 9.5, 6.5}, {4.0, 12.0, 6.5}};
  const Eigen::Vector3d stranger_{5.0, 1.5, 6.8};  ///< where drift may have put the first
  std::size_t known_ = 0;
};

TEST_F(SecondVisitTest, WhatMayBeEitherOfTwoLikeObjectsIsLeftOpenAndShownAsNeither) {
  VisitAll({{5.0, 0.0, 6.8}, {5.0, 1.2, 6.8}});
  SeeAgain(first_[1]);
  EXPECT_EQ(Found().size(), known_);
  EXPECT_EQ(CountInDoubt(), 1);
}

TEST_F(SecondVisitTest, WhatWasLeftOpenIsDecidedByWhatIsSeenNext) {
  VisitAll({{5.0, 0.0, 6.8}, {5.0, 1.2, 6.8}});
  SeeAgain(first_[1]);
  SeeOthers();
  FlyTo(5.0, 19.0);
  EXPECT_EQ(CountInDoubt(), 0);
  EXPECT_EQ(Found().size(), known_);
  EXPECT_LT(NearestTo(first_[0]), 0.3);
  EXPECT_LT(NearestTo(first_[1]), 0.3);
}

TEST_F(SecondVisitTest, AWrongRecognitionIsTakenBackWhenWhatIsSeenNextContradictsIt) {
  VisitAll({{5.0, 0.0, 6.8}});
  SeeAgain(stranger_);
  ASSERT_EQ(Found().size(), known_) << "nothing tells it from the known one so far";
  SeeOthers();
  FlyTo(5.0, 19.0);
  EXPECT_EQ(Found().size(), known_ + 1);
  EXPECT_LT(NearestTo(first_[0]), 0.3);
  EXPECT_LT(NearestTo(stranger_), 0.3);
}

TEST_F(SecondVisitTest, ARecognitionThatIsTakenBackNoLongerPullsThePose) {
  VisitAll({{5.0, 0.0, 6.8}});
  SeeAgain(stranger_);
  EXPECT_GT(PoseError(), 1.0);
  SeeOthers();
  FlyTo(5.0, 19.0);
  EXPECT_LT(PoseError(), 0.2);
}

TEST_F(SecondVisitTest, LooksOfAMistakenObjectAreAnObjectOfTheirOwnOnceTheyDoNotFit) {
  const auto fix = [this] {
    const int head = smoother_.graph().node_count() - 1;
    smoother_.AddTerm(head, Term::OnPose(PosePriorFactor(truth_, NavVector::Constant(0.01))));
  };
  FlyTo(5.0, -4.0);
  fix();
  VisitAll({{5.0, 0.0, 6.8}});
  SeeAgain(stranger_);
  static_cast<void>(tracker_.Conclude());  // for good, but for what comes
  ASSERT_EQ(Found().size(), known_);
  fix();  // tells where the vehicle really is, then the object is seen once more
  FlyTo(5.0, 1.5);
  FlyTo(5.0, 9.0);
  static_cast<void>(tracker_.Conclude());
  smoother_.Converge();
  tracker_.Refresh();
  EXPECT_EQ(Found().size(), known_ + 1);
  // A third of their distance: each is nearer to its own place than to the middle.
  EXPECT_LT(NearestTo(first_[0]), 0.5);
  EXPECT_LT(NearestTo(stranger_), 0.5);
}

TEST_F(SecondVisitTest, BoxesOfARecognisedObjectAreGivenItsNameAtOnce) {
  VisitAll({{5.0, 0.0, 6.8}});
  objects_ = first_;
  FlyTo(5.0, 0.0);
  ASSERT_EQ(shown_.size(), 1U);
  FlyTo(5.0, 2.0);
  ASSERT_EQ(shown_.size(), 1U);
  EXPECT_EQ(shown_[0], Found()[0].id());
}

TEST_F(SecondVisitTest, TheEndOfTheSessionGivesALandmarkTheLooksOfAllVisits) {
  VisitAll({{5.0, 0.0, 6.8}});
  const double before = time_;
  SeeAgain(first_[0]);
  static_cast<void>(tracker_.Conclude());
  smoother_.Update();
  ASSERT_EQ(Found().size(), known_);
  EXPECT_GT(Found()[0].observations.back().t, before);
}

}  // namespace
}  // namespace limpet
