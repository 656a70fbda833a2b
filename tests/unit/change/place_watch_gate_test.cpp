// SPDX-License-Identifier: MIT
// How near a box must be to be a place's, and what a false one there would be worth.
#include <cmath>
#include <cstdint>
#include <numbers>

#include <gtest/gtest.h>

#include "estimation/change/place_watch.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

BoxOwner NobodyKnown(const ObservedFrame&, const Box&) { return BoxOwner::kUnknown; }

/// A place straight below a vehicle, and the box of an object there.
struct GateScene {
  WatchModel model;
  ObjectEstimate place;
  ObservedFrame frame;
  double distance = 0.0;  ///< [m]
  [[nodiscard]] Box BoxThere() const {
    const double size = 2.0 * model.look.object_radius * model.look.camera.fx / distance;
    return {.u = model.look.camera.cx,
            .v = model.look.camera.cy,
            .w = size,
            .h = size,
            .confidence = 0.9,
            .color = "yellow"};
  }
};

class PlaceWatchGate : public ::testing::TestWithParam<int> {
 protected:
  [[nodiscard]] GateScene Draw(double sigma) {
    GateScene scene;
    scene.distance = random_.Uniform(2.0, 4.0);
    scene.model.look.object_radius = random_.Uniform(0.2, 0.6);
    scene.model.look.detection.false_per_image = random_.Uniform(0.02, 0.5);
    scene.place = {.p_W = {random_.Normal(9.0), random_.Normal(9.0), 6.0},
                   .cov_W = sigma * sigma * Eigen::Matrix3d::Identity(),
                   .color = "yellow"};
    scene.frame.X_WB.p_WB = scene.place.p_W - Eigen::Vector3d(0.0, 0.0, scene.distance);
    return scene;
  }
  /// Three sigmas: six pixels, the place, and 15 % of the size.
  [[nodiscard]] static double GateOf(const GateScene& scene, double sigma) {
    const double per_metre = scene.model.look.camera.fx / scene.distance;
    return 3.0 *
           std::hypot(6.0, std::hypot(sigma, 0.3 * scene.model.look.object_radius) * per_metre);
  }
  Random random_{static_cast<std::uint64_t>(GetParam()), "gate"};
};

TEST_P(PlaceWatchGate, IsThreeSigmasOfBoxPlaceAndSizeWide) {
  for (const double sigma : {0.0, 0.1, 0.4}) {
    const GateScene scene = Draw(sigma);
    const auto foresight = Foresee(scene.place, scene.frame.X_WB, scene.model);
    ASSERT_TRUE(foresight);
    EXPECT_NEAR(foresight->gate, GateOf(scene, sigma), 1e-9);
    EXPECT_NEAR(foresight->radius,
                scene.model.look.object_radius * scene.model.look.camera.fx / scene.distance, 1e-9);
  }
}

TEST_P(PlaceWatchGate, ABoxIsFoundInItAndNotBeyond) {
  const GateScene scene = Draw(0.1);
  const double gate = GateOf(scene, 0.1), way = random_.Uniform(-3.1, 3.1);
  for (const double share : {0.98, 1.02}) {
    ObservedFrame frame = scene.frame;
    Box box = scene.BoxThere();
    box.u += share * gate * std::cos(way);
    box.v += share * gate * std::sin(way);
    frame.boxes = {box};
    EXPECT_EQ(FindBox(frame, scene.place, scene.model, NobodyKnown) != nullptr, share < 1.0);
  }
}

TEST_P(PlaceWatchGate, ABoxMustBeFromSixTenthsToSixteenTenthsOfTheSize) {
  const GateScene scene = Draw(0.1);
  for (const double share : {0.58, 0.62, 1.58, 1.62}) {
    ObservedFrame frame = scene.frame;
    Box box = scene.BoxThere();
    box.w *= share, box.h *= share;
    frame.boxes = {box};
    const bool is_possible = share > 0.6 && share < 1.6;
    EXPECT_EQ(FindBox(frame, scene.place, scene.model, NobodyKnown) != nullptr, is_possible)
        << share;
  }
}

/// ln of the chance of a box where nothing is, from what one frame with a box says of a place.
double LogFalseAlarm(const GateScene& scene) {
  PlaceWatch watch(scene.place, LookParams{});
  ObservedFrame frame = scene.frame;
  frame.boxes = {scene.BoxThere()};
  watch.See(frame, scene.model, NobodyKnown);
  const double present_over_bare = watch.evidence().present(0);
  return watch.LogLikelihood({.chance = 0.5, .look_worth = 1.0})(0) - std::log(0.5) -
         std::log1p(std::exp(present_over_bare));
}

TEST_P(PlaceWatchGate, AFalseBoxIsAsRareAsItsColourSizeAndPlaceTogether) {
  const GateScene scene = Draw(0.0);
  const CameraModel& camera = scene.model.look.camera;
  const double gate = GateOf(scene, 0.0);
  const double share = std::numbers::pi * gate * gate / (camera.width_px * camera.height_px);
  // One in four has the colour, two in five the size.
  EXPECT_NEAR(LogFalseAlarm(scene),
              std::log(0.25 * 0.4 * scene.model.look.detection.false_per_image * share), 1e-9);
}

TEST_P(PlaceWatchGate, HoweverFewFalseBoxesThereAreOneIsNotProof) {
  GateScene scene = Draw(0.0);
  scene.model.look.detection.false_per_image = 1e-7;
  EXPECT_NEAR(LogFalseAlarm(scene), std::log(2e-5), 1e-9);
}

TEST_P(PlaceWatchGate, HoweverManyThereAreABoxSaysALittle) {
  GateScene scene = Draw(0.0);
  scene.model.look.detection.false_per_image = 1e4;  // as a broken detector teaches
  EXPECT_NEAR(LogFalseAlarm(scene), std::log(0.2), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Drawn, PlaceWatchGate, ::testing::Range(1, 11));

}  // namespace
}  // namespace limpet
