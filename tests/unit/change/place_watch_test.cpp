// SPDX-License-Identifier: MIT
// What a frame says about a place, and what many of them together say.
#include "estimation/change/place_watch.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "estimation/change/log_space.hpp"
#include "estimation/change/watched_place.hpp"
#include "limpet/core/random.hpp"
#include "tests/unit/change/lambda.hpp"

namespace limpet {
namespace {

const WatchModel kWatchModel{};

ObjectEstimate PlaceAt(const Eigen::Vector3d& p_W, double sigma = 0.15) {
  return {.p_W = p_W, .cov_W = sigma * sigma * Eigen::Matrix3d::Identity(), .color = "yellow"};
}

/// A vehicle 3 m above the place, which lies that far ahead and to starboard of it.
ObservedFrame FrameOver(const Eigen::Vector3d& p_W, double ahead = 0.0, double starboard = 0.0,
                        double time = 0.0) {
  return {.exposure = Seconds(time),
          .X_WB = {{p_W.x() - ahead, p_W.y() - starboard, p_W.z() - 3.0}, 0, 0, 0},
          .altitude = 4.0};
}

/// A box centred that far from where the place appears [px].
Box BoxNear(const ObjectEstimate& place, const ObservedFrame& frame, double off_u = 0.0,
            double off_v = 0.0) {
  const Foresight foresight = *Foresee(place, frame.X_WB, kWatchModel);
  return {.u = foresight.at_px.x() + off_u,
          .v = foresight.at_px.y() + off_v,
          .w = 2.0 * foresight.radius,
          .h = 2.0 * foresight.radius,
          .confidence = 0.9,
          .color = "yellow"};
}

BoxOwner Unknown(const ObservedFrame&, const Box&) { return BoxOwner::kUnknown; }
BoxOwner Own(const ObservedFrame&, const Box&) { return BoxOwner::kThisPlace; }
BoxOwner Other(const ObservedFrame&, const Box&) { return BoxOwner::kAnotherPlace; }

TEST(Foresee, PutsThePlaceWhereTheCameraHasIt) {
  Random random(71);
  const CameraModel& camera = kWatchModel.look.camera;
  int seen = 0;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d p_W(random.Normal(3.0), random.Normal(3.0), random.Uniform(4.0, 9.0));
    const Pose X_WB{{random.Normal(1.0), random.Normal(1.0), 2.0},
                    random.Normal(0.1),
                    random.Normal(0.1),
                    random.Uniform(-3.0, 3.0)};
    const auto foresight = Foresee(PlaceAt(p_W), X_WB, kWatchModel);
    if (!foresight) continue;
    ++seen;
    const Eigen::Vector3d p_C = camera.InCamera(X_WB, p_W);
    EXPECT_LT((foresight->at_px - *camera.Project(p_C)).norm(), 1e-9);
    EXPECT_NEAR(foresight->radius, 0.5 * camera.fx / p_C.z(), 1e-9);
  }
  EXPECT_GT(seen, 100);
}

TEST(Foresee, AnUncertainPlaceHasAWiderGateThatIsNeverNarrowerThanTheBoxesNoise) {
  double before = 18.0;  // three sigma of a box's centre
  for (const double sigma : {0.0, 0.1, 0.3, 1.0, 3.0}) {
    const auto foresight =
        Foresee(PlaceAt({0, 0, 6}, sigma), FrameOver({0, 0, 6}).X_WB, kWatchModel);
    ASSERT_TRUE(foresight);
    EXPECT_GT(foresight->gate, before) << sigma;
    before = foresight->gate;
  }
}

TEST(Foresee, LooksTwoImagesAroundAndNotBehindTheCamera) {
  const auto sees = [](double ahead, double starboard) {
    const Eigen::Vector3d p_W(0, 0, 6);
    return Foresee(PlaceAt(p_W), FrameOver(p_W, ahead, starboard).X_WB, kWatchModel).has_value();
  };
  const CameraModel& camera = kWatchModel.look.camera;
  const double across = 3.0 * 2.0 * camera.width_px / camera.fx;
  const double along = 3.0 * 2.0 * camera.height_px / camera.fy;
  for (const double side : {-1.0, 1.0}) {
    EXPECT_TRUE(sees(0.0, side * (across - 0.01)));
    EXPECT_FALSE(sees(0.0, side * (across + 0.01)));
    EXPECT_TRUE(sees(side * (along - 0.01), 0.0));
    EXPECT_FALSE(sees(side * (along + 0.01), 0.0));
  }
  EXPECT_FALSE(Foresee(PlaceAt({0, 0, 1}), Pose{{0, 0, 3}, 0, 0, 0}, kWatchModel).has_value());
}

TEST(Explains, ABoxAsFarAsTheGateInAnyDirection) {
  Random random(72);
  const Eigen::Vector3d p_W(0, 0, 6);
  const ObservedFrame frame = FrameOver(p_W, 0.3, -0.2);
  const ObjectEstimate place = PlaceAt(p_W);
  const Foresight foresight = *Foresee(place, frame.X_WB, kWatchModel);
  for (int i = 0; i < 200; ++i) {
    const double angle = random.Uniform(-M_PI, M_PI);
    const auto box = [&](double off) {
      return BoxNear(place, frame, off * std::cos(angle), off * std::sin(angle));
    };
    EXPECT_TRUE(foresight.Explains(box(foresight.gate - 0.01), kWatchModel.look.camera)) << angle;
    EXPECT_FALSE(foresight.Explains(box(foresight.gate + 0.01), kWatchModel.look.camera)) << angle;
  }
}

TEST(Explains, ABoxThatTheBorderCutsMayLieARadiusFurtherInside) {
  const Eigen::Vector3d p_W(0, 0, 6);
  // The object's centre is 60 px outside the image; what shows of it lies inside.
  const double starboard = 3.0 * (0.5 * 640.0 + 60.0) / kWatchModel.look.camera.fx;
  const ObservedFrame frame = FrameOver(p_W, 0.0, starboard);
  const Foresight foresight = *Foresee(PlaceAt(p_W), frame.X_WB, kWatchModel);
  ASSERT_GT(foresight.at_px.x(), 640.0);
  const Box shown{.u = 630.0, .v = 240.0, .w = 20.0, .h = 100.0, .confidence = 0.9, .color = ""};
  EXPECT_TRUE(foresight.Explains(shown, kWatchModel.look.camera));
  Box inside = shown;
  inside.u = 640.0 - foresight.gate - 1.0;
  EXPECT_FALSE(foresight.Explains(inside, kWatchModel.look.camera));
}

TEST(FindBox, PrefersABoxOfThePlaceToOneThatMayBe) {
  const ObjectEstimate place = PlaceAt({0, 0, 6});
  ObservedFrame frame = FrameOver(place.p_W);
  frame.boxes = {BoxNear(place, frame), BoxNear(place, frame, 3.0), BoxNear(place, frame)};
  frame.boxes[1].landmark = 4;
  const OwnerOf owner = [](const ObservedFrame&, const Box& box) {
    return box.landmark == 4 ? BoxOwner::kThisPlace : BoxOwner::kUnknown;
  };
  EXPECT_EQ(FindBox(frame, place, kWatchModel, owner), &frame.boxes[1]);
}

TEST(FindBox, ABoxOfAnotherPlaceIsNoneOfThisOneHoweverNear) {
  const ObjectEstimate place = PlaceAt({0, 0, 6});
  ObservedFrame frame = FrameOver(place.p_W);
  frame.boxes = {BoxNear(place, frame)};
  EXPECT_NE(FindBox(frame, place, kWatchModel, Unknown), nullptr);
  EXPECT_EQ(FindBox(frame, place, kWatchModel, Other), nullptr);
}

TEST(FindBox, AnObjectsOwnBoxIsFoundWhateverItsColourAndSize) {
  const ObjectEstimate place = PlaceAt({0, 0, 6});
  ObservedFrame frame = FrameOver(place.p_W);
  frame.boxes = {BoxNear(place, frame, 150.0)};
  frame.boxes[0].color = "red";
  frame.boxes[0].w = 5.0;
  EXPECT_NE(FindBox(frame, place, kWatchModel, Own), nullptr);
  EXPECT_EQ(FindBox(frame, place, kWatchModel, Unknown), nullptr);
}

TEST(FindBox, ABoxOfUnknownOwnerMustHaveTheColour) {
  ObjectEstimate place = PlaceAt({0, 0, 6});
  ObservedFrame frame = FrameOver(place.p_W);
  frame.boxes = {BoxNear(place, frame)};
  frame.boxes[0].color = "red";
  EXPECT_EQ(FindBox(frame, place, kWatchModel, Unknown), nullptr);
  place.color.clear();  // of which nobody knows the colour
  EXPECT_NE(FindBox(frame, place, kWatchModel, Unknown), nullptr);
}

TEST(FindBox, ABoxOfUnknownOwnerMustHaveAboutTheSize) {
  const ObjectEstimate place = PlaceAt({0, 0, 6});
  ObservedFrame frame = FrameOver(place.p_W);
  const auto is_found = [&](double w_share, double h_share) {
    frame.boxes = {BoxNear(place, frame)};
    frame.boxes[0].w *= w_share, frame.boxes[0].h *= h_share;
    return FindBox(frame, place, kWatchModel, Unknown) != nullptr;
  };
  EXPECT_TRUE(is_found(0.61, 1.0));
  EXPECT_FALSE(is_found(0.59, 1.0));
  EXPECT_FALSE(is_found(1.0, 0.59));
  EXPECT_TRUE(is_found(1.59, 1.0));
  EXPECT_FALSE(is_found(1.0, 1.61));
}

TEST(PlaceWatchProperties, WhatIsOutOfSightSaysNothing) {
  PlaceWatch watch(PlaceAt({0, 0, 6}), LookParams{});
  const double before = trial::Lambda(watch);
  EXPECT_NEAR(before, 0.0, 1e-12);
  for (int i = 0; i < 20; ++i)
    watch.See(FrameOver({0, 0, 6}, 60.0 + i, 0.0, i), kWatchModel, Unknown);
  EXPECT_EQ(trial::Lambda(watch), before);
  EXPECT_EQ(watch.looks()(0), 0);
}

/// A pass north over the place, with a box in each frame of which `shows` says so.
template <class Shows>
PlaceWatch Pass(const ObjectEstimate& place, double starboard, const Shows& shows,
                const WatchModel& model = kWatchModel) {
  PlaceWatch watch(place, LookParams{});
  for (int i = 0; i < 24; ++i) {
    ObservedFrame frame = FrameOver(place.p_W, 1.8 - 0.15 * i, starboard, 0.3 * i);
    if (shows(i)) frame.boxes = {BoxNear(place, frame)};
    watch.See(frame, model, Unknown);
  }
  return watch;
}

TEST(PlaceWatchProperties, NothingSpeaksMoreForAnObjectThanABoxInEveryFrameNorAgainstThanNone) {
  Random random(73);
  for (int i = 0; i < 100; ++i) {
    const double share = random.Uniform(0.0, 1.0);
    const ObjectEstimate place = PlaceAt({random.Normal(9), random.Normal(9), 6.0});
    const double starboard = random.Uniform(-1.0, 1.0);
    const double some =
        trial::Lambda(Pass(place, starboard, [&](int) { return random.Chance(share); }));
    EXPECT_LE(some, trial::Lambda(Pass(place, starboard, [](int) { return true; })) + 1e-9);
    EXPECT_GE(some, trial::Lambda(Pass(place, starboard, [](int) { return false; })) - 1e-9);
  }
}

TEST(PlaceWatchProperties, APassToStarboardSaysWhatOneToPortSays) {
  Random random(74);
  for (int i = 0; i < 50; ++i) {
    const double starboard = random.Uniform(0.0, 2.2);
    const bool shows = random.Chance(0.5);
    const auto all = [shows](int) { return shows; };
    const PlaceWatch right = Pass(PlaceAt({0, 0, 6}), starboard, all);
    const PlaceWatch left = Pass(PlaceAt({0, 0, 6}), -starboard, all);
    // How much of an object shows at the border is counted by points that lie unevenly.
    EXPECT_NEAR(trial::Lambda(right), trial::Lambda(left), 0.01) << starboard;
    EXPECT_EQ(right.looks()(0), left.looks()(0)) << starboard;
  }
}

TEST(PlaceWatchProperties, CleanLooksAtAnUncertainPlaceProveLessThanAtACertainOne) {
  double before = -1e9;
  for (const double sigma : {0.05, 0.5, 1.0, 2.0}) {
    const double lambda =
        trial::Lambda(Pass(PlaceAt({0, 0, 6}, sigma), 0.0, [](int) { return false; }));
    EXPECT_LT(lambda, 0.0);
    EXPECT_GE(lambda, before - 1e-9) << sigma;
    before = lambda;
  }
}

TEST(PlaceWatchProperties, ABoxProvesLessWhereTheDetectorSeesMoreGhosts) {
  double before = 1e9;
  for (const double ghosts : {0.01, 0.03, 0.1, 0.4}) {
    WatchModel model = kWatchModel;
    model.look.detection.false_per_image = ghosts;
    const double lambda = trial::Lambda(Pass(
        PlaceAt({0, 0, 6}, 0.5), 0.0, [](int) { return true; }, model));
    EXPECT_LE(lambda, before) << ghosts;
    before = lambda;
  }
}

TEST(PlaceWatchProperties, LooksWithABoxAreSomeOfTheLooks) {
  Random random(75);
  for (int i = 0; i < 60; ++i) {
    const PlaceWatch watch = Pass(PlaceAt({0, 0, 6}), random.Uniform(-1.5, 1.5),
                                  [&random](int) { return random.Chance(0.4); });
    EXPECT_LE(watch.looks_with_box(), watch.looks()(0));
    EXPECT_GT(watch.looks()(0), 0);
    EXPECT_TRUE(std::isfinite(trial::Lambda(watch)));
  }
}

TEST(HasMoved, AThirdOfAMetreOrAThirdOfTheSpreadIsWorthANewJudgement) {
  const PlaceWatch watch(PlaceAt({0, 0, 6}, 1.0), LookParams{});
  EXPECT_FALSE(HasMoved(watch, PlaceAt({0.29, 0, 6}, 1.0)));
  EXPECT_TRUE(HasMoved(watch, PlaceAt({0.31, 0, 6}, 1.0)));
  EXPECT_FALSE(HasMoved(watch, PlaceAt({0, 0, 6}, 1.29)));
  EXPECT_TRUE(HasMoved(watch, PlaceAt({0, 0, 6}, 1.31)));
  EXPECT_FALSE(HasMoved(watch, PlaceAt({0, 0, 6}, 0.71)));
  EXPECT_TRUE(HasMoved(watch, PlaceAt({0, 0, 6}, 0.69)));
}

TEST(HasMoved, APlaceThatWasExactIsNotJudgedAgainForCentimetres) {
  const PlaceWatch watch(PlaceAt({0, 0, 6}, 0.01), LookParams{});
  EXPECT_FALSE(HasMoved(watch, PlaceAt({0, 0, 6}, 0.07)));
  EXPECT_TRUE(HasMoved(watch, PlaceAt({0, 0, 6}, 0.09)));
}

TEST(LogSum, IsTheLogarithmOfTheSumAndNeitherOverflowsNorCaresForTheOrder) {
  Random random(76);
  for (int i = 0; i < 200; ++i) {
    const double a = random.Normal(5.0), b = random.Normal(5.0);
    EXPECT_NEAR(LogSum(a, b), std::log(std::exp(a) + std::exp(b)), 1e-9);
    EXPECT_EQ(LogSum(a, b), LogSum(b, a));
  }
  EXPECT_NEAR(LogSum(2000.0, 2000.0), 2000.0 + std::log(2.0), 1e-9);
  EXPECT_EQ(LogSum(-2000.0, 3.0), 3.0);
}

TEST(PlaceWatch, WhatAnObstacleHidesWasNotLookedAt) {
  const ObjectEstimate place = PlaceAt({2.0, 0.0, 7.0});
  WatchModel behind = kWatchModel;
  behind.obstacles = SightObstacles(
      {{.id = 1, .outline = {{1.0, -0.6}, {1.0, 0.6}, {1.3, 0.6}, {1.3, -0.6}}, .top = 0.0}});
  PlaceWatch clear_watch(place, {}), hidden_watch(place, {});
  for (int i = 0; i < 20; ++i) {
    const ObservedFrame frame = FrameOver(place.p_W, 1.5, 0.1 * i - 1.0, 10.0 * i);
    clear_watch.See(frame, kWatchModel, Unknown);
    hidden_watch.See(frame, behind, Unknown);
  }
  EXPECT_LT(clear_watch.evidence().present.minCoeff(), -1.0) << "twenty looks that showed nothing";
  EXPECT_GT(hidden_watch.evidence().present.minCoeff(), -0.3);
}

}  // namespace
}  // namespace limpet
