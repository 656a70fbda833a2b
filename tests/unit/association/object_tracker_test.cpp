// SPDX-License-Identifier: MIT
#include "estimation/association/object_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "estimation/smoothing/arrow_smoother.hpp"
#include "estimation/smoothing/camera_point.hpp"
#include "estimation/smoothing/factors/depth_factor.hpp"
#include "estimation/smoothing/factors/pose_prior_factor.hpp"
#include "estimation/smoothing/factors/roll_pitch_factor.hpp"
#include "estimation/smoothing/factors/xyz_yaw_factor.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

using namespace literals;

/// A vehicle flies straight lines at 0.5 m/s, 4 m above the seabed at 7.5 m, four frames a second.
class ObjectTrackerTest : public ::testing::Test {
 protected:
  /// Flies to (north, east); `drift` is added to what odometry says of each step [m].
  void FlyTo(double north, double east, double drift_east = 0.0) {
    const Eigen::Vector2d way = Eigen::Vector2d(north, east) - truth_.head<2>();
    const int steps = std::max(1, static_cast<int>(way.norm() / 0.125));
    for (int i = 0; i < steps; ++i) {
      truth_.head<2>() += way / steps;
      Step({way.x() / steps, way.y() / steps + drift_east / steps});
      Look();
    }
  }
  void Step(const Eigen::Vector2d& moved) {
    const int count = smoother_.graph().node_count();
    NavVector x = count == 0 ? truth_ : smoother_.PoseAt(count - 1);
    if (count == 0) {
      smoother_.AddNode(x, std::nullopt);
      smoother_.AddTerm(0, Term::OnPose(PosePriorFactor(x, NavVector::Constant(0.05))));
    } else {
      x.head<2>() += moved;
      const double drift = step_sigma_ * step_sigma_;
      const Eigen::Vector4d variance(drift, drift, 1e-4, 1e-8);
      smoother_.AddNode(x, Term::OnStep(XyzYawFactor({moved.x(), moved.y(), 0.0, 0.0}, variance)));
    }
    smoother_.AddTerm(count, Term::OnPose(DepthFactor(Meters(truth_(kNavZ)), 0.02_m)));
    smoother_.AddTerm(count,
                      Term::OnPose(RollPitchFactor(Radians(0.0), Radians(0.0), Radians(0.005))));
    smoother_.Update();
    path_ += moved.norm();
  }
  void Look() {
    FrameDetections frame{.frame = frame_++, .t = time_ += 0.25, .boxes = {}};
    for (const Eigen::Vector3d& object : objects_) {
      const auto box = BoxOfSphere(CameraPointOf(camera_, truth_, object).p_C, 0.5, camera_);
      if (!box || box->w < 20.0 || box->h < 20.0) continue;
      BoxDetection seen = *box;
      if (!random_.Chance(hit_share_)) continue;
      seen.confidence = confidence_, seen.color = "yellow";
      if (seen.u - 0.5 * seen.w > 2.0 && seen.u + 0.5 * seen.w < 638.0) {
        seen.u += random_.Normal(2.0);
      }
      frame.boxes.push_back(seen);
    }
    if (random_.Chance(false_share_)) {
      frame.boxes.push_back({.u = random_.Uniform(50.0, 590.0),
                             .v = random_.Uniform(50.0, 430.0),
                             .w = random_.Uniform(40.0, 140.0),
                             .h = random_.Uniform(40.0, 140.0),
                             .confidence = random_.Uniform(0.3, 0.7),
                             .color = "yellow"});
    }
    const int node = smoother_.graph().node_count() - 1;
    shown_ = tracker_.Process({.detections = &frame,
                               .x = smoother_.PoseAt(node),
                               .node = node,
                               .path = path_,
                               .altitude = 4.0});
    smoother_.Update();
    tracker_.Refresh();
    if (tracker_.Review()) {
      smoother_.Update();
      tracker_.Refresh();
    }
  }
  std::vector<TrackedObject> Found() const {
    std::vector<TrackedObject> found;
    for (const TrackedObject& object : tracker_.objects()) {
      if (object.is_landmark()) found.push_back(object);
    }
    return found;
  }

  Random random_{3};
  const CameraModel camera_;
  ArrowSmoother smoother_;
  ObjectTracker tracker_{smoother_, camera_, ObjectTrackerParams{}};
  NavVector truth_ = (NavVector() << 0.0, 0.0, 3.5, 0.0, 0.0, 0.0).finished();
  std::vector<Eigen::Vector3d> objects_;
  std::vector<int> shown_;
  double hit_share_ = 1.0, confidence_ = 0.85;
  double false_share_ = 0.0, step_sigma_ = 0.003, time_ = 0.0, path_ = 0.0;
  int frame_ = 0;
};

TEST_F(ObjectTrackerTest, FindsAnObjectWhereItIs) {
  objects_ = {{5.0, 0.5, 6.5}};
  FlyTo(10.0, 0.0);
  ASSERT_EQ(Found().size(), 1U);
  EXPECT_LT((Found()[0].p - objects_[0]).norm(), 0.15);
}

TEST_F(ObjectTrackerTest, NamesTheLandmarkThatABoxShows) {
  objects_ = {{5.0, 0.5, 6.5}};
  FlyTo(5.0, 0.0);
  ASSERT_EQ(shown_.size(), 1U);
  EXPECT_EQ(shown_[0], Found()[0].id);
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
  EXPECT_NEAR((Found()[0].p - Found()[1].p).norm(), 1.2, 0.25);
}

TEST_F(ObjectTrackerTest, RecognisesAnObjectAfterALongWayRound) {
  objects_ = {{5.0, 0.5, 6.5}};
  FlyTo(10.0, 0.0);
  FlyTo(10.0, 15.0);
  FlyTo(5.0, 15.0);
  FlyTo(5.0, -3.0);
  ASSERT_EQ(Found().size(), 1U);
  EXPECT_EQ(Found()[0].id, 1);
}

TEST_F(ObjectTrackerTest, RecognisesAnObjectAfterDriftThatOdometryAdmits) {
  objects_ = {{5.0, 0.5, 6.5}};
  step_sigma_ = 0.08;
  FlyTo(10.0, 0.0);
  FlyTo(10.0, 15.0, 0.6);
  FlyTo(5.0, 15.0);
  FlyTo(5.0, -3.0);
  ASSERT_EQ(Found().size(), 1U);
  EXPECT_LT((Found()[0].p - objects_[0]).norm(), 0.3);
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
    const double off = std::min((Found()[0].p - object).norm(), (Found()[1].p - object).norm());
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
  EXPECT_EQ(Found()[0].id, 1);
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
  int InDoubt() const {
    return static_cast<int>(std::ranges::count_if(
        tracker_.objects(), [](const TrackedObject& o) { return o.is_in_doubt; }));
  }
  double NearestTo(const Eigen::Vector3d& place) const {
    double nearest = 99.0;
    for (const TrackedObject& object : Found())
      nearest = std::min(nearest, (object.p - place).norm());
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
  EXPECT_EQ(InDoubt(), 1);
}

TEST_F(SecondVisitTest, WhatWasLeftOpenIsDecidedByWhatIsSeenNext) {
  VisitAll({{5.0, 0.0, 6.8}, {5.0, 1.2, 6.8}});
  SeeAgain(first_[1]);
  SeeOthers();
  FlyTo(5.0, 19.0);
  EXPECT_EQ(InDoubt(), 0);
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
  EXPECT_EQ(shown_[0], Found()[0].id);
}

TEST_F(SecondVisitTest, TheEndOfTheSessionGivesALandmarkTheLooksOfAllVisits) {
  VisitAll({{5.0, 0.0, 6.8}});
  const double before = time_;
  SeeAgain(first_[0]);
  static_cast<void>(tracker_.Conclude());
  smoother_.Update();
  ASSERT_EQ(Found().size(), known_);
  EXPECT_GT(Found()[0].looks.back().t, before);
}

}  // namespace
}  // namespace limpet
