// SPDX-License-Identifier: MIT
// What boxes that nothing explains may and may not lead to.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "estimation/change/tentative_objects.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

const WatchModel kTentativeModel{};

ObservedFrame FrameFrom(double time, const Eigen::Vector3d& p_WB) {
  return {.exposure = Seconds(time), .X_WB = {p_WB, 0, 0, 0}, .altitude = 4.0};
}

/// What a detector that sees the whole object has of it.
Box WholeBox(const ObservedFrame& frame, const Eigen::Vector3d& p_W) {
  const CameraModel& camera = kTentativeModel.look.camera;
  const Eigen::Vector3d p_C = camera.InCamera(frame.X_WB, p_W);
  const Eigen::Vector2d pixel = *camera.Project(p_C);
  return {.u = pixel.x(),
          .v = pixel.y(),
          .w = camera.fx / p_C.z(),
          .h = camera.fy / p_C.z(),
          .confidence = 0.9,
          .color = "yellow"};
}

bool NothingIsKnown(const ObservedFrame&, const Box&) { return false; }

/// So many boxes of an object, a quarter of a second apart, from one place.
void ShowBoxes(TentativeObjects& tentative, int boxes, double start = 0.0,
               const Eigen::Vector3d& p_W = {0.0, 0.0, 6.0}) {
  for (int i = 0; i < boxes; ++i) {
    ObservedFrame frame = FrameFrom(start + 0.25 * i, p_W - Eigen::Vector3d(0.5, 0.0, 3.0));
    frame.boxes = {WholeBox(frame, p_W)};
    tentative.AddFrame(frame, kTentativeModel, NothingIsKnown);
  }
}
/// The time is now `time`, far from everything.
std::size_t CountOpenAt(TentativeObjects& tentative, double time) {
  tentative.AddFrame(FrameFrom(time, {500.0, 500.0, 3.0}), kTentativeModel, NothingIsKnown);
  return tentative.Open().size();
}

TEST(PlaceOfBoxProperties, IsThePlaceOfTheObjectFromAnyPose) {
  Random random(131);
  for (int i = 0; i < 300; ++i) {
    const Pose X_WB{{random.Normal(50), random.Normal(50), 3.0},
                    random.Normal(0.05),
                    random.Normal(0.05),
                    random.Uniform(-3.0, 3.0)};
    const CameraModel& camera = kTentativeModel.look.camera;
    const double depth = random.Uniform(1.8, 3.5);
    const Eigen::Vector3d p_C(depth * random.Uniform(-0.5, 0.5), depth * random.Uniform(-0.3, 0.3),
                              depth);
    const ObservedFrame frame{.exposure = Seconds(0.0), .X_WB = X_WB, .altitude = 4.0};
    const Eigen::Vector3d p_W = X_WB.p_WB + RotationOf(X_WB) * (camera.R_BC * p_C + camera.p_BC);
    const Box box = WholeBox(frame, p_W);
    if (IsCut(box, camera)) continue;
    const auto place = PlaceOfBox(box, frame, kTentativeModel);
    ASSERT_TRUE(place) << i;
    EXPECT_LT((*place - p_W).norm(), 1e-6) << i;
  }
}

TEST(PlaceOfBoxProperties, NoPlaceIsDeeperThanTheSeabedAllows) {
  Random random(132);
  for (int i = 0; i < 500; ++i) {
    ObservedFrame frame = FrameFrom(0.0, {0.0, 0.0, 3.0});
    frame.altitude = random.Uniform(1.0, 8.0);
    const Box box{.u = random.Uniform(0.0, 640.0),
                  .v = random.Uniform(0.0, 480.0),
                  .w = random.Uniform(0.0, 640.0),
                  .h = random.Uniform(0.0, 480.0),
                  .confidence = 0.9,
                  .color = "yellow"};
    const auto place = PlaceOfBox(box, frame, kTentativeModel);
    if (!place) continue;
    EXPECT_TRUE(place->allFinite());
    EXPECT_LE(place->z(), 3.0 + *frame.altitude + 0.7 + 1e-9);
    EXPECT_GE(place->z(), 3.0 + 0.5 - 1e-9);
  }
}

TEST(TentativeObjectsProperties, ThreeBoxesHintAtAnObjectAndTwoDoNot) {
  for (const int boxes : {1, 2, 3, 6}) {
    TentativeObjects tentative;
    ShowBoxes(tentative, boxes);
    EXPECT_EQ(CountOpenAt(tentative, 10.0), boxes >= 3 ? 1U : 0U) << boxes;
  }
}

TEST(TentativeObjectsProperties, TooFewBoxesAreForgottenAfterTheirPass) {
  for (const double pause : {19.0, 21.0}) {
    TentativeObjects tentative;
    ShowBoxes(tentative, 2);
    ShowBoxes(tentative, 1, 0.25 + pause);
    EXPECT_EQ(CountOpenAt(tentative, 0.25 + pause + 5.0), pause < 20.0 ? 1U : 0U) << pause;
  }
}

TEST(TentativeObjectsProperties, IsOpenOnceBoxesHaveStoppedAndUntilItHasGrownOld) {
  TentativeObjects tentative;
  ShowBoxes(tentative, 3);  // the last at 0.5 s
  for (const auto& [time, is_open] : {std::pair(3.4, false), std::pair(3.6, true),
                                      std::pair(400.4, true), std::pair(400.6, false)})
    EXPECT_EQ(CountOpenAt(tentative, time), is_open ? 1U : 0U) << time;
}

TEST(TentativeObjectsProperties, BoxesOfDifferentColoursOrPlacesDoNotAddUp) {
  TentativeObjects tentative;
  for (int i = 0; i < 4; ++i) {
    ObservedFrame frame = FrameFrom(0.25 * i, {0.0, 0.0, 3.0});
    frame.boxes = {WholeBox(frame, {0.0, 0.0, 6.0})};
    frame.boxes[0].color = i % 2 == 0 ? "yellow" : "red";
    tentative.AddFrame(frame, kTentativeModel, NothingIsKnown);
  }
  EXPECT_EQ(CountOpenAt(tentative, 10.0), 0U);
  for (const double apart : {1.1, 1.3}) {
    TentativeObjects two;
    ShowBoxes(two, 2);
    ShowBoxes(two, 1, 1.0, {0.0, apart, 6.0});
    EXPECT_EQ(CountOpenAt(two, 10.0), apart < 1.2 ? 1U : 0U) << apart;
  }
}

TEST(TentativeObjectsProperties, WhatIsExplainedHintsAtNothing) {
  TentativeObjects tentative;
  for (int i = 0; i < 6; ++i) {
    ObservedFrame frame = FrameFrom(0.25 * i, {0.0, 0.0, 3.0});
    frame.boxes = {WholeBox(frame, {0.0, 0.0, 6.0})};
    tentative.AddFrame(frame, kTentativeModel,
                       [](const ObservedFrame&, const Box&) { return true; });
  }
  EXPECT_EQ(CountOpenAt(tentative, 10.0), 0U);
}

TEST(TentativeObjectsProperties, ThreeGoodLooksFromPlacesOfTheirOwnAreEnough) {
  TentativeObjects tentative;
  ShowBoxes(tentative, 3);
  // Its first boxes were a good look; from there on every half metre is another.
  double time = 20.0;
  const auto look_from = [&](double north) {
    tentative.AddFrame(FrameFrom(time += 1.0, {north, 0.0, 3.0}), kTentativeModel, NothingIsKnown);
    return CountOpenAt(tentative, time + 5.0);
  };
  EXPECT_EQ(look_from(0.01), 1U);
  EXPECT_EQ(look_from(0.02), 1U) << "the same viewpoint";
  EXPECT_EQ(look_from(0.1), 1U) << "the same viewpoint";
  EXPECT_EQ(look_from(0.6), 0U);
}

TEST(TentativeObjectsProperties, ADetectorThatSeesGhostsSendsNobodyToMoreThanEightPlaces) {
  TentativeObjects tentative;
  for (int i = 0; i < 12; ++i)
    ShowBoxes(tentative, 3, 10.0 * i, {10.0 * i, 0.0, 6.0});
  EXPECT_EQ(CountOpenAt(tentative, 130.0), 8U);
  EXPECT_EQ(tentative.left_out(), 4);
  EXPECT_EQ(CountOpenAt(tentative, 131.0), 8U);
  EXPECT_EQ(tentative.left_out(), 4) << "each is counted once";
}

TEST(TentativeObjectsProperties, ItsPlaceIsTheMeanOfItsBoxes) {
  Random random(133);
  for (int i = 0; i < 50; ++i) {
    TentativeObjects tentative;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int k = 0; k < 8; ++k) {
      const Eigen::Vector3d p_W(random.Uniform(-0.15, 0.15), random.Uniform(-0.15, 0.15), 6.0);
      sum += p_W;
      ShowBoxes(tentative, 1, 0.25 * k, p_W);
    }
    ASSERT_EQ(CountOpenAt(tentative, 10.0), 1U);
    EXPECT_LT((tentative.Open()[0]->place.p_W - sum / 8.0).norm(), 1e-6);
  }
}

}  // namespace
}  // namespace limpet
