// SPDX-License-Identifier: MIT
#include "estimation/change/object_statuses.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/change/object_statuses_fixture.hpp"

namespace limpet {
namespace {

/// A fix at the end moves everything; an object at the image's border must not fall out of it.
TEST_F(ObjectStatusesTest, TakesItsFramesAlongWhenAFixMovesTheTrack) {
  const ObjectEstimate object = At(4, 0.5);
  Fly(0.0, {{object, 1}});
  Fly(3.4, {});  // passes by: the object is outside the image
  const Eigen::Vector3d shift(0.2, 0.9, 0.0);
  statuses_.MoveFrames([&shift](double, Pose X_WB) {
    X_WB.p_WB += shift;
    return X_WB;
  });
  ObjectEstimate moved = object;
  moved.p_W += shift;
  Landmarks({{moved, 1}});
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kNew));
}

TEST_F(ObjectStatusesTest, JudgesALandmarkAlsoFromFramesBeforeItWasConfirmed) {
  const Real real{At(4, 0.5), 1};
  Fly(0.0, {{real.object, -1}});
  Landmarks({real});
  ASSERT_EQ(statuses_.Assess().size(), 1U);
  EXPECT_EQ(statuses_.Assess()[0].decided, Status::kNew);
  EXPECT_GE(statuses_.Assess()[0].looks_with_box, 3);
}

TEST_F(ObjectStatusesTest, BoxesThatNoLandmarkExplainsAreWorthALook) {
  Fly(0.0, {{At(4, 2.4), -1}});
  statuses_.AddFrame({.exposure = Seconds(time_), .X_WB = {{90.0, 90.0, 3.0}, 0, 0, 0}});
  const std::vector<OpiBelief> objects = statuses_.Assess();
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0].decided, Status::kUncertain);
  EXPECT_EQ(objects[0].landmark, std::nullopt);
  EXPECT_GT(objects[0].posterior.Entropy(), 0.25);
}

TEST_F(ObjectStatusesTest, DropsALandmarkThatCleanLooksDisprove) {
  Fly(0.0, {});
  Fly(0.5, {});
  Landmarks({{At(4, 0.5), 1}});
  EXPECT_TRUE(statuses_.Assess().empty());
}

TEST_F(ObjectStatusesTest, ForgetsALandmarkThatTheSmootherDropped) {
  const Real real{At(4, 0.5), 1};
  Fly(0.0, {real});
  Landmarks({real});
  Landmarks({});
  EXPECT_TRUE(statuses_.Assess().empty());
}

TEST_F(ObjectStatusesTest, TakesTwoLandmarksOfOneObjectForOne) {
  Fly(0.0, {{At(4, 0.5), 1}});
  Fly(0.5, {{At(4, 0.5), 2}});
  Landmarks({{At(4, 0.5), 1}, {At(4.6, 0.9), 2}});
  ASSERT_EQ(statuses_.Assess().size(), 1U);
  EXPECT_EQ(statuses_.Representative(2), 1);
}

TEST_F(ObjectStatusesTest, KeepsTwoNeighboursApartThatWereSeenTogether) {
  const std::vector<Real> two{{At(4, 0.0), 1}, {At(4, 1.1), 2}};
  Fly(0.5, two);
  Landmarks(two);
  EXPECT_EQ(statuses_.Assess().size(), 2U);
}

TEST_F(ObjectStatusesTest, LearnsHowOftenTheDetectorSeesGhosts) {
  const Real real{At(4, 0.5), 1};
  for (int pass = 0; pass < 6; ++pass) {
    Fly(0.0, {real});
  }
  for (int i = 0; i < 600; ++i, time_ += 0.25) {
    ObservedFrame frame{.exposure = Seconds(time_), .X_WB = {{90.0, 90.0, 3.0}, 0, 0, 0}};
    if (i % 2 == 0) frame.boxes.push_back({.u = 30, .v = 30, .w = 40, .h = 40, .color = "green"});
    statuses_.AddFrame(std::move(frame));
  }
  Landmarks({real});
  statuses_.Rejudge();
  EXPECT_NEAR(statuses_.false_per_image(), 300.0 / 1374.0, 0.03) << "the object's boxes are none";
}

TEST_F(ObjectStatusesTest, FalseDetectionsNeverAddUpToAnObject) {
  // One random box in every tenth frame, and a smoother that believes in one of them.
  for (double north = -4.0; north <= 12.0; north += 0.125, time_ += 0.25) {
    ObservedFrame frame{.exposure = Seconds(time_), .X_WB = {{north, 0.0, 3.0}, 0, 0, 0}};
    if (random_.Chance(0.1)) {
      frame.boxes.push_back({.u = random_.Uniform(0, 640),
                             .v = random_.Uniform(0, 480),
                             .w = 80,
                             .h = 80,
                             .confidence = 0.5,
                             .color = "yellow"});
    }
    statuses_.AddFrame(std::move(frame));
  }
  for (double north = -2.0; north <= 10.0; north += 0.7) {
    Landmarks({{At(north, 0.8), 1}});
    for (const OpiBelief& object : statuses_.Assess()) {
      EXPECT_EQ(object.decided, Status::kUncertain) << north;
    }
  }
}

}  // namespace
}  // namespace limpet
