// SPDX-License-Identifier: MIT
// Objects of other sizes than the mission says: what pNav estimated of each tells how it looks.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "estimation/change/object_statuses.hpp"
#include "estimation/change/watched_place.hpp"
#include "tests/unit/change/object_statuses_fixture.hpp"

namespace limpet {
namespace {

ObjectEstimate Sized(ObjectEstimate object, double radius, double sd = 0.01) {
  object.size = ObjectSize{.radius = radius, .sd = sd};
  return object;
}

/// A mission that says 0.5 m, and objects of which each is as large as it is.
class ObjectSizeTest : public ObjectStatusesTest, public ::testing::WithParamInterface<double> {
 protected:
  /// Boxes as large as an object of that radius shows, of which pNav knows no landmark yet.
  void FlyOver(const std::vector<ObjectEstimate>& objects, double radius) {
    for (double north = -4.0; north <= 12.0; north += 0.125, time_ += 0.25) {
      ObservedFrame frame{
          .exposure = Seconds(time_), .X_WB = {{north, 0.0, 3.0}, 0, 0, 0}, .altitude = 4.0};
      for (const ObjectEstimate& object : objects) {
        const Eigen::Vector3d p_C = kCamera.InCamera(frame.X_WB, object.p_W);
        if (VisibleShare(kCamera, frame.X_WB, object.p_W, radius) < 0.9) continue;
        const Eigen::Vector2d pixel = *kCamera.Project(p_C);
        const double size = 2.0 * radius * kCamera.fx / p_C.z();
        frame.boxes.push_back({.u = pixel.x(),
                               .v = pixel.y(),
                               .w = size,
                               .h = size,
                               .confidence = 0.9,
                               .color = object.color});
      }
      statuses_.AddFrame(std::move(frame));
    }
    time_ += 30.0;
  }
};

TEST_P(ObjectSizeTest, OneThatPNavKnowsIsAnObjectOfTheMap) {
  const Real real{Sized(At(4.0, 0.3), GetParam()), 1};
  FlyOver({real.object}, GetParam());
  Landmarks({real});
  const std::vector<OpiBelief> objects = statuses_.Assess();
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0].decided, Status::kNew);
  EXPECT_EQ(statuses_.landmarks_doubted(), 0);
}

TEST_P(ObjectSizeTest, OneThatIsGoneIsRemovedAndOneThatStaysConfirmed) {
  const ObjectEstimate gone = Sized(At(1.0, 0.3), GetParam());
  const Real stays{Sized(At(6.0, -0.3), GetParam()), 1, {.id = 8}};
  FormerLookedEverywhere();
  statuses_.SetFormer({Former(7, gone), Former(8, stays.object)});
  FlyOver({stays.object}, GetParam());
  Landmarks({stays});
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kRemoved, Status::kConfirmed));
}

TEST_P(ObjectSizeTest, IsSeenAtAFormerPlaceBeforePNavKnowsALandmarkThere) {
  statuses_.SetFormer({Former(7, Sized(At(4.0, 0.3), GetParam()))});
  FlyOver({At(4.0, 0.3)}, GetParam());
  EXPECT_NE(Decided()[0], Status::kRemoved);
}

/// The former session's smoother made nothing of its boxes; they are in its frames.
TEST_P(ObjectSizeTest, IsNotNewWhereTheFormerSessionSawItsBoxes) {
  const Real real{Sized(At(4.0, 0.3), GetParam()), 1};
  FlyOver({real.object}, GetParam());
  FormerViews views{.frames = statuses_.frames(),
                    .model = {.look = {.camera = kCamera, .detection = {}}},
                    .looks = {}};
  statuses_.SetFormer({});
  statuses_.SetFormerViews(std::move(views));
  Landmarks({real});
  EXPECT_THAT(Decided(), ::testing::Not(::testing::Contains(Status::kNew)));
}

INSTANTIATE_TEST_SUITE_P(Radius, ObjectSizeTest, ::testing::Values(0.2, 0.3, 0.5, 0.8));

/// As files of sessions before sizes were estimated have it.
TEST_F(ObjectStatusesTest, AnObjectWithoutASizeIsAsLargeAsTheMissionSays) {
  statuses_.SetFormer({Former(7, At(4.4, 0.2))});
  const Real real{At(4, 0.5), 1, {.id = 7}};
  Fly(0.0, {real});
  Landmarks({real});
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kConfirmed));
}

TEST_F(ObjectStatusesTest, ASizeThatPNavLearnsLaterCounts) {
  const Real unsized{At(4.0, 0.3), 1};
  for (double north = -4.0; north <= 12.0; north += 0.125, time_ += 0.25) {
    ObservedFrame frame{
        .exposure = Seconds(time_), .X_WB = {{north, 0.0, 3.0}, 0, 0, 0}, .altitude = 4.0};
    const Eigen::Vector3d p_C = kCamera.InCamera(frame.X_WB, unsized.object.p_W);
    if (VisibleShare(kCamera, frame.X_WB, unsized.object.p_W, 0.2) >= 0.9) {
      const Eigen::Vector2d pixel = *kCamera.Project(p_C);
      frame.boxes.push_back({.u = pixel.x(), .v = pixel.y(), .w = 50, .h = 50, .color = "yellow"});
    }
    statuses_.AddFrame(std::move(frame));
  }
  Landmarks({unsized});
  EXPECT_TRUE(statuses_.Assess().empty());
  Landmarks({{Sized(unsized.object, 0.2), 1}});
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kNew));
}

TEST_F(ObjectStatusesTest, TellsOfALandmarkWithManyDetectionsThatItTakesForNone) {
  Fly(0.0, {});
  Fly(0.5, {});
  statuses_.SetLandmarks({{.id = 1, .object = At(4, 0.5), .detections = 12},
                          {.id = 2, .object = At(1, -0.5), .detections = 3}});
  static_cast<void>(statuses_.Assess());
  EXPECT_EQ(statuses_.landmarks_doubted(), 1) << "three detections may well be false ones";
  statuses_.SetLandmarks({});
  static_cast<void>(statuses_.Assess());
  EXPECT_EQ(statuses_.landmarks_doubted(), 0);
}

TEST(ObjectSize, IsForeseenAsEstimatedElseAsTheMissionSays) {
  const WatchModel model{};
  const Pose X_WB{{4.0, 0.0, 3.0}, 0, 0, 0};
  const double per_metre =
      model.look.camera.fx / model.look.camera.InCamera(X_WB, At(4, 0).p_W).z();
  EXPECT_NEAR(Foresee(At(4, 0), X_WB, model)->radius, 0.5 * per_metre, 1e-9);
  EXPECT_NEAR(Foresee(Sized(At(4, 0), 0.2), X_WB, model)->radius, 0.2 * per_metre, 1e-9);
  EXPECT_NEAR(Foresee(Sized(At(4, 0), 0.0), X_WB, model)->radius, 0.5 * per_metre, 1e-9)
      << "no size at all";
}

TEST(ObjectSize, WhatIsUnknownOfItWidensWhatPassesForIt) {
  const WatchModel model{};
  ObservedFrame frame{.exposure = Seconds(0.0), .X_WB = {{4.0, 0.0, 3.0}, 0, 0, 0}};
  const auto is_found = [&](double share, double sd) {
    const ObjectEstimate place = Sized(At(4, 0), 0.3, sd);
    const Foresight foresight = *Foresee(place, frame.X_WB, model);
    const double size = 2.0 * share * foresight.radius;
    frame.boxes = {{.u = foresight.at_px.x(),
                    .v = foresight.at_px.y(),
                    .w = size,
                    .h = size,
                    .confidence = 0.9,
                    .color = "yellow"}};
    return FindBox(frame, place, model,
                   [](const ObservedFrame&, const Box&) { return BoxOwner::kUnknown; }) != nullptr;
  };
  for (const double share : {0.5, 1.9}) {
    EXPECT_FALSE(is_found(share, 0.001)) << share;
    EXPECT_TRUE(is_found(share, 0.06)) << share;
  }
  EXPECT_FALSE(is_found(4.5, 10.0)) << "nothing known is not everything allowed";
}

TEST(ObjectSize, APlaceIsJudgedAnewOnceItsSizeIsAnother) {
  const PlaceWatch watch(Sized(At(4, 0), 0.5), LookParams{});
  EXPECT_FALSE(HasMoved(watch, Sized(At(4, 0), 0.52)));
  EXPECT_TRUE(HasMoved(watch, Sized(At(4, 0), 0.6)));
  EXPECT_TRUE(HasMoved(watch, At(4, 0)));
}

}  // namespace
}  // namespace limpet
