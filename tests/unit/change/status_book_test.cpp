// SPDX-License-Identifier: MIT
#include "estimation/change/status_book.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

const CameraModel kCamera;

ObjectEstimate At(double north, double east, const std::string& color = "yellow") {
  return {.p_W = {north, east, 6.0}, .cov_W = 0.04 * Eigen::Matrix3d::Identity(), .color = color};
}

/// A book and a vehicle that flies north over the field at 3 m above the objects.
class StatusBookTest : public ::testing::Test {
 protected:
  struct Real {
    ObjectEstimate object;
    int landmark = -1;
    std::optional<int> former_id = std::nullopt;
    std::vector<FormerCandidate> candidates = {};
  };
  void Fly(double east, const std::vector<Real>& objects, double detects = 1.0) {
    for (double north = -4.0; north <= 12.0; north += 0.125, time_ += 0.25) {
      ObservedFrame sight{.exposure = Seconds(time_), .X_WB = {{north, east, 3.0}, 0, 0, 0}};
      for (const Real& real : objects) {
        const Eigen::Vector3d p_C = kCamera.InCamera(sight.X_WB, real.object.p_W);
        const Eigen::Vector2d pixel = *kCamera.Project(p_C);
        if (VisibleShare(kCamera, sight.X_WB, real.object.p_W, 0.5) < 0.5) continue;
        if (!random_.Chance(detects)) continue;
        sight.boxes.push_back({.u = pixel.x(),
                               .v = pixel.y(),
                               .w = 120,
                               .h = 120,
                               .confidence = 0.9,
                               .color = real.object.color,
                               .landmark = real.landmark});
      }
      book_.AddSight(std::move(sight));
    }
    time_ += 30.0;
  }
  /// The former session flew north over the field and saw what its list has.
  void FormerLookedEverywhere() {
    FormerViews views{.sights = {}, .model = {.camera = kCamera, .detection = {}}, .looks = {}};
    for (double north = -4.0; north <= 12.0; north += 0.5) {
      views.sights.push_back(
          {.exposure = Seconds(north + 4.0), .X_WB = {{north, 0.0, 3.0}, 0, 0, 0}});
    }
    book_.SetFormerViews(std::move(views));
  }
  void Landmarks(const std::vector<Real>& objects) {
    std::vector<Landmark> known;
    for (const Real& real : objects) {
      known.push_back({.id = real.landmark,
                       .object = real.object,
                       .looks = 10 - real.landmark,
                       .is_confirmed = true,
                       .former_id = real.former_id,
                       .former_candidates = real.candidates});
    }
    book_.SetLandmarks(known);
  }
  std::vector<Status> Decided() {
    std::vector<Status> decided;
    for (const OpiBelief& object : book_.Assess())
      decided.push_back(object.decided);
    return decided;
  }
  static FormerObject Former(int id, const ObjectEstimate& object) {
    return {.id = id, .object = object, .log_likelihood_ratio = 8.0, .looks = 5};
  }

  Random random_{7};
  double time_ = 0.0;
  StatusBook book_{StatusParams{}, kCamera};
};

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

TEST_F(StatusBookTest, AnObjectThatAnotherColourReplacedIsRemoved) {
  FormerLookedEverywhere();
  book_.SetFormer({Former(7, At(0, 0.5)), Former(8, At(7, 0.0)), Former(9, At(4, 0.5))});
  const std::vector<Real> now{{At(0, 0.5), 1, 7}, {At(7, 0.0), 2, 8}, {At(4, 0.5, "orange"), 3}};
  Fly(0.0, now);
  Landmarks(now);
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kConfirmed, Status::kConfirmed,
                                                Status::kRemoved, Status::kNew));
}

TEST_F(StatusBookTest, AnObjectThatStandsBesideItsFormerPlaceHasMoved) {
  FormerLookedEverywhere();
  book_.SetFormer({Former(7, At(0, 0.5)), Former(8, At(8, 0.0)), Former(9, At(4, 0.5))});
  const std::vector<Real> now{{At(0, 0.5), 1, 7}, {At(8, 0.0), 2, 8}, {At(4, -1.0), 3}};
  Fly(0.0, now);
  Landmarks(now);
  EXPECT_THAT(Decided(),
              ::testing::ElementsAre(Status::kConfirmed, Status::kConfirmed, Status::kMoved));
}

TEST_F(StatusBookTest, AFormerObjectThatIsStillThereIsConfirmed) {
  book_.SetFormer({Former(7, At(4.4, 0.2))});
  const Real real{At(4, 0.5), 1, 7};
  Fly(0.0, {real});
  Landmarks({real});
  ASSERT_THAT(Decided(), ::testing::ElementsAre(Status::kConfirmed));
  EXPECT_EQ(book_.Assess()[0].prior_id, 7);
  EXPECT_EQ(book_.Assess()[0].landmark, 1);
}

TEST_F(StatusBookTest, AFormerObjectThatCleanLooksMissIsRemoved) {
  book_.SetFormer({Former(7, At(4.4, 0.2))});
  Fly(0.0, {});
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kRemoved));
}

TEST_F(StatusBookTest, AFormerObjectOutOfSightStaysUncertain) {
  book_.SetFormer({Former(7, At(4.4, 9.0))});
  Fly(0.0, {});
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kUncertain));
  EXPECT_EQ(book_.Assess()[0].looks, 0);
}

TEST_F(StatusBookTest, BoxesOfALandmarkToBeDoNotLeaveItsFormerObjectRemoved) {
  book_.SetFormer({Former(7, At(4.4, 0.2))});
  Fly(0.0, {{At(4, 0.5), -1}});
  EXPECT_NE(Decided()[0], Status::kRemoved);
}

TEST_F(StatusBookTest, ANewObjectIsNewWhenTheFormerSessionLookedThere) {
  const Real real{At(4, 0.5), 1};
  book_.SetFormer({});
  FormerLookedEverywhere();
  Fly(0.0, {real});
  Landmarks({real});
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kNew));
}

TEST_F(StatusBookTest, AnObjectWhereNobodyLookedBeforeMayBeOld) {
  const Real real{At(4, 0.5), 1};
  book_.SetFormer({});
  book_.SetFormerViews(
      {.sights = {{.exposure = Seconds(0.0), .X_WB = {{100.0, 0.0, 3.0}, 0, 0, 0}}},
       .model = {.camera = kCamera, .detection = {}},
       .looks = {}});
  Fly(0.0, {real});
  Landmarks({real});
  const std::vector<OpiBelief> objects = book_.Assess();
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0].decided, Status::kUncertain);
  EXPECT_GT(objects[0].posterior.present(), 0.9);
}

TEST_F(StatusBookTest, AFormerSessionThatNeverLookedProvesNothing) {
  const Real real{At(4, 0.5), 1};
  book_.SetFormer({});
  Fly(0.0, {real});
  Landmarks({real});
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kUncertain));
}

/// The former smoother made no object of what its camera saw.
TEST_F(StatusBookTest, AnObjectIsNotNewWhereTheFormerSessionSawBoxesThatItDidNotList) {
  const Real real{At(4, 0.5), 1};
  FormerViews views{.sights = {}, .model = {.camera = kCamera, .detection = {}}, .looks = {}};
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
    views.sights.push_back(std::move(view));
  }
  book_.SetFormerViews(std::move(views));
  book_.SetFormer({});
  Fly(0.0, {real});
  Landmarks({real});
  EXPECT_NE(Decided()[0], Status::kNew);
}

TEST_F(StatusBookTest, JudgedAgainItDoesNotDependOnHowItCameToKnow) {
  const Real early{At(4.2, 0.7), 1};
  const Real late{At(4, 0.5), 1};
  FormerLookedEverywhere();
  book_.SetFormer({Former(7, At(8, 0.0))});
  Fly(0.0, {late}, 0.8);
  Landmarks({early});
  Landmarks({late});
  book_.Rejudge();
  StatusBook again(StatusParams{}, kCamera);
  for (const ObservedFrame& sight : book_.sights())
    again.AddSight(sight);
  again.SetFormer({Former(7, At(8, 0.0))});
  again.SetLandmarks({{.id = 1, .object = late.object, .looks = 9, .is_confirmed = true}});
  again.Rejudge();
  const std::vector<OpiBelief> first = book_.Assess();
  const std::vector<OpiBelief> second = again.Assess();
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].log_likelihood_ratio, second[i].log_likelihood_ratio);
  }
}

TEST_F(StatusBookTest, AnObjectThatMovedIsOneStoryNotTwo) {
  FormerLookedEverywhere();
  book_.SetFormer({Former(7, At(4, -1.2)), Former(8, At(9, 0)), Former(9, At(0, 0))});
  const std::vector<Real> now{{At(4, 1.1), 1}, {At(9, 0), 2, 8}, {At(0, 0), 3, 9}};
  Fly(-0.5, now);
  Fly(0.5, now);
  Landmarks(now);
  EXPECT_THAT(Decided(),
              ::testing::ElementsAre(Status::kConfirmed, Status::kConfirmed, Status::kMoved));
  EXPECT_EQ(book_.Assess().back().prior_id, 7);
}

TEST_F(StatusBookTest, KeepsAnObjectsIdWhenItIsFoundAgain) {
  book_.SetFormer({Former(7, At(4, 0.5)), Former(8, At(9, 0))});
  const int before = book_.Assess()[1].id;
  const Real real{At(9, 0.2), 1, 8};
  Fly(0.0, {real});
  Landmarks({real});
  EXPECT_EQ(book_.Assess()[1].id, before);
}

/// Which landmark is which former object is pNav's to say, however near another one stands.
TEST_F(StatusBookTest, BelievesTheMatchThatItIsTold) {
  book_.SetFormer({Former(7, At(4, 0.2)), Former(8, At(4, 1.4))});
  const std::vector<Real> now{{At(4, 0.8), 1, 8}};
  Fly(0.5, now);
  Landmarks(now);
  const std::vector<OpiBelief> objects = book_.Assess();
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0].landmark, -1);
  EXPECT_EQ(objects[1].landmark, 1);
  EXPECT_EQ(objects[1].prior_id, 8);
  EXPECT_EQ(objects[1].decided, Status::kConfirmed);
}

TEST_F(StatusBookTest, ALandmarkAtAFormerPlaceIsNewIfItIsToldToBeAnother) {
  FormerLookedEverywhere();
  book_.SetFormer({Former(7, At(4, 0.5, "orange"))});
  const Real real{At(4, 0.5), 1};
  Fly(0.0, {real});
  Landmarks({real});
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kRemoved, Status::kNew));
}

TEST_F(StatusBookTest, TheFrameThatDriftedHalfAMetreIsThatOfTheMatches) {
  book_.SetFormer({Former(7, At(0, 0.0)), Former(8, At(4, 0.5)), Former(9, At(8, 0.2))});
  const std::vector<Real> now{{At(0.5, 0.0), 1, 7}, {At(8.5, 0.2), 3, 9}};
  Fly(0.0, now);
  Landmarks(now);
  EXPECT_NEAR(book_.offset().shift.x(), 0.5, 0.05);
  EXPECT_THAT(Decided(),
              ::testing::ElementsAre(Status::kConfirmed, Status::kRemoved, Status::kConfirmed));
  EXPECT_NEAR(book_.Assess()[1].object.p_W.x(), 4.5, 0.1) << "taken along";
}

/// It may be the former object, or one that came while that one went.
TEST_F(StatusBookTest, AnUndecidedLandmarkIsNeitherSurelyNewNorConfirmed) {
  FormerLookedEverywhere();
  book_.SetFormer({Former(7, At(4, -0.5))});
  const Real real{At(4, 1.2), 1, std::nullopt, {{.id = 7, .probability = 0.6}}};
  Fly(0.5, {real});
  Landmarks({real});
  const std::vector<OpiBelief> objects = book_.Assess();
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

TEST_F(StatusBookTest, OneOfTwoCloseFormerObjectsIsLeftAndNobodyKnowsWhich) {
  FormerLookedEverywhere();
  book_.SetFormer({Former(7, At(4, 0.0)), Former(8, At(4, 0.9))});
  const Real real{At(4, 0.4), 1, 7, {{7, 0.55}, {8, 0.45}}};
  Fly(0.5, {real});
  Landmarks({real});
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kUncertain, Status::kUncertain));
  EXPECT_NEAR(book_.Assess()[0].posterior.confirmed, 0.55, 0.05);
  EXPECT_NEAR(book_.Assess()[1].posterior.confirmed, 0.45, 0.05);
}

/// Which is which does not matter then.
TEST_F(StatusBookTest, TwoCloseFormerObjectsThatAreBothStillThereAreConfirmed) {
  book_.SetFormer({Former(7, At(4, 0.0)), Former(8, At(4, 1.0))});
  const std::vector<Real> now{{At(4, 0.1), 1, 7, {{7, 0.6}, {8, 0.4}}},
                              {At(4, 1.1), 2, 8, {{7, 0.4}, {8, 0.6}}}};
  Fly(0.5, now);
  Landmarks(now);
  EXPECT_THAT(Decided(), ::testing::ElementsAre(Status::kConfirmed, Status::kConfirmed));
}

TEST_F(StatusBookTest, AMatchIsKeptWhenItsLandmarkIsMergedIntoAnother) {
  book_.SetFormer({Former(7, At(4, 0.5))});
  Fly(0.0, {{At(4, 0.5), 1}});
  Fly(0.5, {{At(4, 0.5), 2}});
  Landmarks({{At(4, 0.5), 1}, {At(4.6, 0.9), 2, 7}});
  ASSERT_EQ(book_.Assess().size(), 1U);
  EXPECT_EQ(book_.Assess()[0].landmark, 1);
  EXPECT_EQ(book_.Assess()[0].decided, Status::kConfirmed);
}

TEST_F(StatusBookTest, MatchesWithAnotherFormerSessionSayNothing) {
  FormerLookedEverywhere();
  book_.SetFormer({});
  const Real real{At(4, 0.5), 1, 99};
  Fly(0.0, {real});
  Landmarks({real});
  EXPECT_EQ(book_.Assess()[0].prior_id, -1);
  EXPECT_EQ(book_.Assess()[0].decided, Status::kNew);
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
