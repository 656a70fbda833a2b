// SPDX-License-Identifier: MIT
// What statuses make of the former session.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "estimation/change/object_statuses.hpp"
#include "tests/unit/change/object_statuses_fixture.hpp"

namespace limpet {
namespace {

class StatusFormerTest : public ObjectStatusesTest {};

TEST_F(StatusFormerTest, AnObjectThatAnotherColourReplacedIsRemoved) {
  FormerLookedEverywhere();
  statuses_.SetFormer({Former(7, At(0, 0.5)), Former(8, At(7, 0.0)), Former(9, At(4, 0.5))});
  const std::vector<Real> now{
      {At(0, 0.5), 1, {.id = 7}}, {At(7, 0.0), 2, {.id = 8}}, {At(4, 0.5, "orange"), 3}};
  Fly(0.0, now);
  Landmarks(now);
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kConfirmed, Status::kConfirmed,
                                                Status::kRemoved, Status::kNew));
}

TEST_F(StatusFormerTest, AnObjectThatStandsBesideItsFormerPlaceHasMoved) {
  FormerLookedEverywhere();
  statuses_.SetFormer({Former(7, At(0, 0.5)), Former(8, At(8, 0.0)), Former(9, At(4, 0.5))});
  const std::vector<Real> now{
      {At(0, 0.5), 1, {.id = 7}}, {At(8, 0.0), 2, {.id = 8}}, {At(4, -1.0), 3}};
  Fly(0.0, now);
  Landmarks(now);
  EXPECT_THAT(Decided(),
              ::testing::ElementsAre(Status::kConfirmed, Status::kConfirmed, Status::kMoved));
}

TEST_F(StatusFormerTest, AFormerObjectThatIsStillThereIsConfirmed) {
  statuses_.SetFormer({Former(7, At(4.4, 0.2))});
  const Real real{At(4, 0.5), 1, {.id = 7}};
  Fly(0.0, {real});
  Landmarks({real});
  ASSERT_THAT(Decided(), ::testing::ElementsAre(Status::kConfirmed));
  EXPECT_EQ(statuses_.Assess()[0].former_id, 7);
  EXPECT_EQ(statuses_.Assess()[0].landmark, 1);
}

TEST_F(StatusFormerTest, AFormerObjectThatCleanLooksMissIsRemoved) {
  statuses_.SetFormer({Former(7, At(4.4, 0.2))});
  Fly(0.0, {});
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kRemoved));
}

TEST_F(StatusFormerTest, AFormerObjectOutOfSightIsNotInspected) {
  statuses_.SetFormer({Former(7, At(4.4, 9.0))});
  Fly(0.0, {});
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kNotInspected));
  EXPECT_EQ(statuses_.Assess()[0].looks, 0);
}

TEST_F(StatusFormerTest, BoxesOfALandmarkToBeDoNotLeaveItsFormerObjectRemoved) {
  statuses_.SetFormer({Former(7, At(4.4, 0.2))});
  Fly(0.0, {{At(4, 0.5), -1}});
  EXPECT_NE(Decided()[0], Status::kRemoved);
}

TEST_F(StatusFormerTest, ANewObjectIsNewWhenTheFormerSessionLookedThere) {
  const Real real{At(4, 0.5), 1};
  statuses_.SetFormer({});
  FormerLookedEverywhere();
  Fly(0.0, {real});
  Landmarks({real});
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kNew));
}

TEST_F(StatusFormerTest, AnObjectMayBeOldIfTheFormerWaterWasTooMurkyToSeeIt) {
  const Real real{At(4, 0.5), 1};
  statuses_.SetFormer({});
  // By its own account it saw the place; but that account is rough, and 3 m are hardly enough.
  FormerLookedEverywhere({Meters(3.6), Meters(1.9)});
  Fly(0.0, {real});
  Landmarks({real});
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kUncertain));
  EXPECT_GT(statuses_.Assess()[0].posterior.present(), 0.9);
}

TEST_F(StatusFormerTest, ManyNewcomersMakeItLikelyThatTheFormerSessionSawLittle) {
  const Real one{At(4, 0.5), 1}, other{At(1, -0.5), 2}, third{At(7, 0.0), 3};
  statuses_.SetFormer({});
  FormerLookedEverywhere({Meters(5.0), Meters(2.2)});
  Fly(0.0, {one, other, third});
  Landmarks({one});
  const double alone = statuses_.Assess()[0].posterior.appeared;
  Landmarks({one, other, third});
  EXPECT_LT(statuses_.Assess()[0].posterior.appeared, alone);
}

TEST_F(StatusFormerTest, AnObjectWhereNobodyLookedBeforeMayBeOld) {
  const Real real{At(4, 0.5), 1};
  statuses_.SetFormer({});
  statuses_.SetFormerViews(
      {.frames = {{.exposure = Seconds(0.0), .X_WB = {{100.0, 0.0, 3.0}, 0, 0, 0}}},
       .model = {.look = {.camera = kCamera, .detection = {}}},
       .looks = {}});
  Fly(0.0, {real});
  Landmarks({real});
  const std::vector<OpiBelief> objects = statuses_.Assess();
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0].decided, Status::kUncertain);
  EXPECT_GT(objects[0].posterior.present(), 0.9);
}

TEST_F(StatusFormerTest, AFormerSessionThatNeverLookedProvesNothing) {
  const Real real{At(4, 0.5), 1};
  statuses_.SetFormer({});
  Fly(0.0, {real});
  Landmarks({real});
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kUncertain));
}

/// The former smoother made no object of what its camera saw.
TEST_F(StatusFormerTest, AnObjectIsNotNewWhereTheFormerSessionSawBoxesThatItDidNotList) {
  const Real real{At(4, 0.5), 1};
  FormerViews views{
      .frames = {}, .model = {.look = {.camera = kCamera, .detection = {}}}, .looks = {}};
  for (double north = -4.0; north <= 12.0; north += 0.5) {
    ObservedFrame view{.exposure = Seconds(north + 4.0), .X_WB = {{north, 0.0, 3.0}, 0, 0, 0}};
    if (VisibleShare(kCamera, view.X_WB, real.object.p_W, 0.5) > 0.5) {
      const Eigen::Vector2d pixel = *kCamera.Project(kCamera.InCamera(view.X_WB, real.object.p_W));
      view.boxes.push_back({.u = pixel.x(),
                            .v = pixel.y(),
                            .w = 120,
                            .h = 120,
                            .confidence = 0.9,
                            .color = "yellow"});
    }
    views.frames.push_back(std::move(view));
  }
  statuses_.SetFormerViews(std::move(views));
  statuses_.SetFormer({});
  Fly(0.0, {real});
  Landmarks({real});
  EXPECT_NE(Decided()[0], Status::kNew);
}

TEST_F(StatusFormerTest, JudgedAgainItDoesNotDependOnHowItCameToKnow) {
  const Real early{At(4.2, 0.7), 1};
  const Real late{At(4, 0.5), 1};
  FormerLookedEverywhere();
  statuses_.SetFormer({Former(7, At(8, 0.0))});
  Fly(0.0, {late}, 0.8);
  Landmarks({early});
  Landmarks({late});
  statuses_.Rejudge();
  ObjectStatuses again(StatusParams{}, kCamera);
  for (const ObservedFrame& frame : statuses_.frames())
    again.AddFrame(frame);
  again.SetFormer({Former(7, At(8, 0.0))});
  again.SetLandmarks({{.id = 1, .object = late.object, .detections = 9}});
  again.Rejudge();
  const std::vector<OpiBelief> first = statuses_.Assess();
  const std::vector<OpiBelief> second = again.Assess();
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].log_likelihood_ratio, second[i].log_likelihood_ratio);
  }
}

TEST_F(StatusFormerTest, AnObjectThatMovedIsOneStoryNotTwo) {
  FormerLookedEverywhere();
  statuses_.SetFormer({Former(7, At(4, -1.2)), Former(8, At(9, 0)), Former(9, At(0, 0))});
  const std::vector<Real> now{{At(4, 1.1), 1}, {At(9, 0), 2, {.id = 8}}, {At(0, 0), 3, {.id = 9}}};
  Fly(-0.5, now);
  Fly(0.5, now);
  Landmarks(now);
  EXPECT_THAT(Decided(),
              ::testing::ElementsAre(Status::kConfirmed, Status::kConfirmed, Status::kMoved));
  EXPECT_EQ(statuses_.Assess().back().former_id, 7);
}

TEST_F(StatusFormerTest, KeepsAnObjectsIdWhenItIsFoundAgain) {
  statuses_.SetFormer({Former(7, At(4, 0.5)), Former(8, At(9, 0))});
  const int before = statuses_.Assess()[1].id;
  const Real real{At(9, 0.2), 1, {.id = 8}};
  Fly(0.0, {real});
  Landmarks({real});
  EXPECT_EQ(statuses_.Assess()[1].id, before);
}

/// Which landmark is which former object is pNav's to say, however near another one stands.
TEST_F(StatusFormerTest, BelievesTheMatchThatItIsTold) {
  statuses_.SetFormer({Former(7, At(4, 0.2)), Former(8, At(4, 1.4))});
  const std::vector<Real> now{{At(4, 0.8), 1, {.id = 8}}};
  Fly(0.5, now);
  Landmarks(now);
  const std::vector<OpiBelief> objects = statuses_.Assess();
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0].landmark, std::nullopt);
  EXPECT_EQ(objects[1].landmark, 1);
  EXPECT_EQ(objects[1].former_id, 8);
  EXPECT_EQ(objects[1].decided, Status::kConfirmed);
}

TEST_F(StatusFormerTest, ALandmarkAtAFormerPlaceIsNewIfItIsToldToBeAnother) {
  FormerLookedEverywhere();
  statuses_.SetFormer({Former(7, At(4, 0.5, "orange"))});
  const Real real{At(4, 0.5), 1};
  Fly(0.0, {real});
  Landmarks({real});
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kRemoved, Status::kNew));
}

TEST_F(StatusFormerTest, TheFrameThatDriftedHalfAMetreIsThatOfTheMatches) {
  statuses_.SetFormer({Former(7, At(0, 0.0)), Former(8, At(4, 0.5)), Former(9, At(8, 0.2))});
  const std::vector<Real> now{{At(0.5, 0.0), 1, {.id = 7}}, {At(8.5, 0.2), 3, {.id = 9}}};
  Fly(0.0, now);
  Landmarks(now);
  EXPECT_NEAR(statuses_.offset().shift_W.x(), 0.5, 0.05);
  EXPECT_THAT(Decided(),
              ::testing::ElementsAre(Status::kConfirmed, Status::kRemoved, Status::kConfirmed));
  EXPECT_NEAR(statuses_.Assess()[1].object.p_W.x(), 4.5, 0.1) << "taken along";
}

/// It may be the former object, or one that came while that one went.
TEST_F(StatusFormerTest, AnUndecidedLandmarkIsNeitherSurelyNewNorConfirmed) {
  FormerLookedEverywhere();
  statuses_.SetFormer({Former(7, At(4, -0.5))});
  const Real real{At(4, 1.2), 1, {.candidates = {{.id = 7, .probability = 0.6}}}};
  Fly(0.5, {real});
  Landmarks({real});
  const std::vector<OpiBelief> objects = statuses_.Assess();
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0].decided, Status::kUncertain);
  EXPECT_NEAR(objects[0].posterior.confirmed, 0.6, 0.05);
  EXPECT_NEAR(objects[0].posterior.removed, 0.4, 0.05);
  EXPECT_EQ(objects[1].landmark, 1);
  EXPECT_EQ(objects[1].decided, Status::kUncertain);
  EXPECT_NEAR(objects[1].posterior.confirmed, 0.6, 0.05);
  EXPECT_NEAR(objects[1].posterior.appeared, 0.4, 0.05);
  EXPECT_GT(objects[1].posterior.present(), 0.95) << "it is there all the same";
}

TEST_F(StatusFormerTest, WhatMovedOrStayedIsThereAllTheSame) {
  FormerLookedEverywhere();
  statuses_.SetFormer({Former(7, At(4, 0.0))});
  const Real real{At(4, 0.7), 1, {.id = 7, .candidates = {{7, 0.6}}}};
  Fly(0.5, {real});
  Landmarks({real});
  const std::vector<OpiBelief> objects = statuses_.Assess();
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0].decided, Status::kUncertain);
  EXPECT_NEAR(objects[0].posterior.confirmed, 0.6, 0.05);
  EXPECT_GT(objects[0].posterior.present(), 0.95);
}

TEST_F(StatusFormerTest, OneOfTwoCloseFormerObjectsIsLeftAndNobodyKnowsWhich) {
  FormerLookedEverywhere();
  statuses_.SetFormer({Former(7, At(4, 0.0)), Former(8, At(4, 0.9))});
  const Real real{At(4, 0.4), 1, {.id = 7, .candidates = {{7, 0.55}, {8, 0.45}}}};
  Fly(0.5, {real});
  Landmarks({real});
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kUncertain, Status::kUncertain));
  EXPECT_NEAR(statuses_.Assess()[0].posterior.confirmed, 0.55, 0.05);
  EXPECT_NEAR(statuses_.Assess()[1].posterior.confirmed, 0.45, 0.05);
}

/// Which is which does not matter then.
TEST_F(StatusFormerTest, TwoCloseFormerObjectsThatAreBothStillThereAreConfirmed) {
  statuses_.SetFormer({Former(7, At(4, 0.0)), Former(8, At(4, 1.0))});
  const std::vector<Real> now{{At(4, 0.1), 1, {.id = 7, .candidates = {{7, 0.6}, {8, 0.4}}}},
                              {At(4, 1.1), 2, {.id = 8, .candidates = {{7, 0.4}, {8, 0.6}}}}};
  Fly(0.5, now);
  Landmarks(now);
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kConfirmed, Status::kConfirmed));
}

TEST_F(StatusFormerTest, AMatchIsKeptWhenItsLandmarkIsMergedIntoAnother) {
  statuses_.SetFormer({Former(7, At(4, 0.5))});
  Fly(0.0, {{At(4, 0.5), 1}});
  Fly(0.5, {{At(4, 0.5), 2}});
  Landmarks({{At(4, 0.5), 1}, {At(4.6, 0.9), 2, {.id = 7}}});
  ASSERT_EQ(statuses_.Assess().size(), 1U);
  EXPECT_EQ(statuses_.Assess()[0].landmark, 1);
  EXPECT_EQ(statuses_.Assess()[0].decided, Status::kConfirmed);
}

TEST_F(StatusFormerTest, MatchesWithAnotherFormerSessionSayNothing) {
  FormerLookedEverywhere();
  statuses_.SetFormer({});
  const Real real{At(4, 0.5), 1, {.id = 99}};
  Fly(0.0, {real});
  Landmarks({real});
  EXPECT_EQ(statuses_.Assess()[0].former_id, std::nullopt);
  EXPECT_EQ(statuses_.Assess()[0].decided, Status::kNew);
}

}  // namespace
}  // namespace limpet
