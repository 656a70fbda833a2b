// SPDX-License-Identifier: MIT
#include "estimation/change/status_book.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/change/status_book_fixture.hpp"

namespace limpet {
namespace {

/// A fix at the end moves everything; an object at the image's border must not fall out of it.
TEST_F(StatusBookTest, TakesItsFramesAlongWhenAFixMovesTheTrack) {
  const ObjectEstimate object = At(4, 0.5);
  Fly(0.0, {{object, 1}});
  Fly(3.4, {});  // passes by: the object is outside the image
  const Eigen::Vector3d shift(0.2, 0.9, 0.0);
  book_.MoveSights([&shift](double, Pose X_WB) {
    X_WB.p_WB += shift;
    return X_WB;
  });
  ObjectEstimate moved = object;
  moved.p_W += shift;
  Landmarks({{moved, 1}});
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kNew));
}

TEST_F(StatusBookTest, JudgesALandmarkAlsoFromFramesBeforeItWasConfirmed) {
  const Real real{At(4, 0.5), 1};
  Fly(0.0, {{real.object, -1}});
  Landmarks({real});
  ASSERT_EQ(book_.Assess().size(), 1U);
  EXPECT_EQ(book_.Assess()[0].decided, Status::kNew);
  EXPECT_GE(book_.Assess()[0].looks_with_box, 3);
}

TEST_F(StatusBookTest, BoxesThatNoLandmarkExplainsAreWorthALook) {
  Fly(0.0, {{At(4, 2.4), -1}});
  book_.AddSight({.exposure = Seconds(time_), .X_WB = {{90.0, 90.0, 3.0}, 0, 0, 0}});
  const std::vector<OpiBelief> objects = book_.Assess();
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0].decided, Status::kUncertain);
  EXPECT_EQ(objects[0].landmark, -1);
  EXPECT_GT(objects[0].posterior.Entropy(), 0.25);
}

TEST_F(StatusBookTest, DropsALandmarkThatCleanLooksDisprove) {
  Fly(0.0, {});
  Fly(0.5, {});
  Landmarks({{At(4, 0.5), 1}});
  EXPECT_TRUE(book_.Assess().empty());
}

TEST_F(StatusBookTest, ForgetsALandmarkThatTheSmootherDropped) {
  const Real real{At(4, 0.5), 1};
  Fly(0.0, {real});
  Landmarks({real});
  Landmarks({});
  EXPECT_TRUE(book_.Assess().empty());
}

TEST_F(StatusBookTest, TakesTwoLandmarksOfOneObjectForOne) {
  Fly(0.0, {{At(4, 0.5), 1}});
  Fly(0.5, {{At(4, 0.5), 2}});
  Landmarks({{At(4, 0.5), 1}, {At(4.6, 0.9), 2}});
  ASSERT_EQ(book_.Assess().size(), 1U);
  EXPECT_EQ(book_.Representative(2), 1);
}

TEST_F(StatusBookTest, KeepsTwoNeighboursApartThatWereSeenTogether) {
  const std::vector<Real> two{{At(4, 0.0), 1}, {At(4, 1.1), 2}};
  Fly(0.5, two);
  Landmarks(two);
  EXPECT_EQ(book_.Assess().size(), 2U);
}

TEST_F(StatusBookTest, LearnsHowOftenTheDetectorSeesGhosts) {
  const Real real{At(4, 0.5), 1};
  for (int pass = 0; pass < 6; ++pass) {
    Fly(0.0, {real});
  }
  for (int i = 0; i < 600; ++i, time_ += 0.25) {
    ObservedFrame sight{.exposure = Seconds(time_), .X_WB = {{90.0, 90.0, 3.0}, 0, 0, 0}};
    if (i % 2 == 0) sight.boxes.push_back({.u = 30, .v = 30, .w = 40, .h = 40, .color = "green"});
    book_.AddSight(std::move(sight));
  }
  Landmarks({real});
  book_.Rejudge();
  EXPECT_NEAR(book_.false_per_image(), 300.0 / 1374.0, 0.03) << "the object's boxes are none";
}

TEST_F(StatusBookTest, FalseDetectionsNeverAddUpToAnObject) {
  // One random box in every tenth frame, and a smoother that believes in one of them.
  for (double north = -4.0; north <= 12.0; north += 0.125, time_ += 0.25) {
    ObservedFrame sight{.exposure = Seconds(time_), .X_WB = {{north, 0.0, 3.0}, 0, 0, 0}};
    if (random_.Chance(0.1)) {
      sight.boxes.push_back({.u = random_.Uniform(0, 640),
                             .v = random_.Uniform(0, 480),
                             .w = 80,
                             .h = 80,
                             .confidence = 0.5,
                             .color = "yellow",
                             .landmark = -1});
    }
    book_.AddSight(std::move(sight));
  }
  for (double north = -2.0; north <= 10.0; north += 0.7) {
    Landmarks({{At(north, 0.8), 1}});
    for (const OpiBelief& object : book_.Assess()) {
      EXPECT_EQ(object.decided, Status::kUncertain) << north;
    }
  }
}

}  // namespace
}  // namespace limpet
