// SPDX-License-Identifier: MIT
#include "estimation/association/box_gate.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "estimation/smoothing/camera_point.hpp"
#include "limpet/core/random.hpp"
#include "tests/support/sphere_box.hpp"

namespace limpet {
namespace {

constexpr double kRadius = 0.5;

/// A camera that looks down from the body's origin at a sphere; the pose is level.
class BoxGateTest : public ::testing::Test {
 protected:
  /// At a place in the camera's frame [m].
  [[nodiscard]] ExpectedObject ObjectAt(const Eigen::Vector3d& p_C) const {
    return {.p_W = camera_.R_BC * p_C,
            .radius = kRadius,
            .color = "yellow",
            .covariance = PoseObjectCovariance::Zero()};
  }
  [[nodiscard]] ReadDetection BoxOf(const Eigen::Vector3d& p_C, double confidence = 1.0) const {
    return Read([&] {
      Box box = BoxOfSphere(p_C, kRadius, camera_).value();
      box.confidence = confidence, box.color = "yellow";
      return box;
    }());
  }
  [[nodiscard]] ReadDetection Read(const Box& box) const {
    return {box, ReadBox(box, camera_, BoxNoise{})};
  }
  [[nodiscard]] std::optional<BoxMatch> Match(const ReadDetection& seen,
                                              const ExpectedObject& object) const {
    return gate_.Match(seen, NavVector::Zero(), object);
  }
  /// Both axes alike.
  const CameraModel camera_ = [] {
    CameraModel camera;
    camera.fx = camera.fy = 400.0;
    return camera;
  }();
  const BoxGateParams params_{};
  const BoxGate gate_{camera_, params_};
};

TEST_F(BoxGateTest, ABoxWhereTheObjectIsHasNoDistanceAndIsLikelierThanSomethingNew) {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d p_C(random.Uniform(-0.8, 0.8), random.Uniform(-0.5, 0.5),
                              random.Uniform(2.5, 5.0));
    const auto match = Match(BoxOf(p_C), ObjectAt(p_C));
    ASSERT_TRUE(match);
    EXPECT_NEAR(match->distance2, 0.0, 1e-9);
    EXPECT_LT(match->cost, match->new_cost);
  }
}

TEST_F(BoxGateTest, SomethingNewMayBeAnywhereInTheImage) {
  const auto match = Match(BoxOf({0.0, 0.0, 3.0}), ObjectAt({0.0, 0.0, 3.0}));
  EXPECT_NEAR(match->new_cost, -2.0 * std::log(params_.new_object_share / (640.0 * 480.0)), 1e-9);
}

TEST_F(BoxGateTest, TheCostIsTheGaussianOfTheInnovation) {
  // Along the axis of a certain pose: noise of the reading and of the model, both axes alike.
  const ReadDetection seen = BoxOf({0.0, 0.0, 3.0});
  const auto match = Match(seen, ObjectAt({0.0, 0.0, 3.0}));
  const double size = 2.0 * camera_.fx * std::tan(std::asin(kRadius / 3.0));
  const double noise = 2.0 + 0.02 * size, model = 4.0 + 0.08 * size;
  const double variance = noise * noise + model * model;
  EXPECT_NEAR(match->cost, 2.0 * std::log(2.0 * std::numbers::pi * variance) - 2.0 * std::log(0.97),
              1e-9);
}

TEST_F(BoxGateTest, ABoxThatOverlapsTheExpectedOneIsNeverFartherThanSixTenthsOfTheGate) {
  const double size = 2.0 * camera_.fx * std::tan(std::asin(kRadius / 3.0));
  const auto shown = [&](double off, double larger) {
    Box box = BoxOf({0.0, 0.0, 3.0}).box;
    box.u += off * size;
    box.w *= larger, box.h *= larger;
    return Match(Read(box), ObjectAt({0.0, 0.0, 3.0}));
  };
  const double most = 0.6 * params_.chi2_per_gate;
  ASSERT_TRUE(shown(0.39, 1.0));
  EXPECT_NEAR(shown(0.39, 1.0)->distance2, most, 1e-9);
  EXPECT_LT(shown(0.3, 1.0)->distance2, most);
  // Size tells range to a fifth: two and a half of those still overlap, three and a half do not.
  ASSERT_TRUE(shown(0.3, std::exp(-0.5)));
  EXPECT_NEAR(shown(0.3, std::exp(-0.5))->distance2, most, 1e-9);
  ASSERT_TRUE(shown(0.0, std::exp(-0.7)));
  EXPECT_GT(shown(0.0, std::exp(-0.7))->distance2, most);
}

TEST_F(BoxGateTest, AnotherClassCostsTheOddsOfConfusion) {
  ReadDetection seen = BoxOf({0.2, 0.1, 3.0});
  const double of_class = Match(seen, ObjectAt({0.2, 0.1, 3.0}))->cost;
  seen.box.color = "red";
  EXPECT_NEAR(Match(seen, ObjectAt({0.2, 0.1, 3.0}))->cost - of_class, 2.0 * std::log(0.97 / 0.03),
              1e-9);
}

TEST_F(BoxGateTest, TheDistanceGrowsWithTheOffsetUntilTheGateCloses) {
  double before = -1.0;
  bool has_closed = false;
  for (double off = 0.0; off < 2.0; off += 0.05) {
    const auto match = Match(BoxOf({off, 0.0, 3.0}), ObjectAt({0.0, 0.0, 3.0}));
    has_closed = has_closed || !match;
    EXPECT_EQ(match.has_value(), !has_closed) << "the gate does not open again, at " << off;
    if (!match) continue;
    EXPECT_GE(match->distance2, before);
    before = match->distance2;
  }
  EXPECT_TRUE(has_closed);
}

TEST_F(BoxGateTest, OffsetsToEitherSideCountAlike) {
  const ExpectedObject object = ObjectAt({0.0, 0.0, 3.0});
  for (const double off : {0.1, 0.3, 0.5}) {
    const auto right = Match(BoxOf({off, 0.0, 3.0}), object);
    const auto left = Match(BoxOf({-off, 0.0, 3.0}), object);
    ASSERT_EQ(right.has_value(), left.has_value());
    if (!right) continue;
    EXPECT_NEAR(right->cost, left->cost, 1e-9);
  }
}

TEST_F(BoxGateTest, AnUncertainPlaceAdmitsABoxThatACertainOneDoesNot) {
  const ReadDetection seen = BoxOf({1.0, 0.0, 3.0});
  ExpectedObject object = ObjectAt({0.0, 0.0, 3.0});
  EXPECT_FALSE(Match(seen, object));
  object.covariance.bottomRightCorner<3, 3>() = Eigen::Matrix3d::Identity();
  EXPECT_TRUE(Match(seen, object));
}

TEST_F(BoxGateTest, TheSpreadIsTheExpectedPixelsWorstSigma) {
  ExpectedObject object = ObjectAt({0.0, 0.0, 4.0});
  // The camera's x is the body's starboard: 0.3 m of it, 0.1 m ahead.
  object.covariance(7, 7) = 0.09;
  object.covariance(6, 6) = 0.01;
  EXPECT_NEAR(Match(BoxOf({0.0, 0.0, 4.0}), object)->spread_px, 0.3 * camera_.fx / 4.0, 1e-9);
}

TEST_F(BoxGateTest, WhatPoseAndPlaceHaveInCommonDoesNotSpread) {
  ExpectedObject object = ObjectAt({0.0, 0.0, 4.0});
  for (const int i : {0, 1, 2}) {
    for (const int j : {i, i + 6}) {
      object.covariance(i, j) = object.covariance(j, i) = 4.0;
    }
    object.covariance(i + 6, i + 6) = 4.0;
  }
  EXPECT_NEAR(Match(BoxOf({0.0, 0.0, 4.0}), object)->spread_px, 0.0, 1e-6);
}

TEST_F(BoxGateTest, ABoxOfAnotherSizeIsAnotherObject) {
  EXPECT_FALSE(Match(BoxOf({0.0, 0.0, 6.0}), ObjectAt({0.0, 0.0, 2.0})));
  const auto near = Match(BoxOf({0.0, 0.0, 3.3}), ObjectAt({0.0, 0.0, 3.0}));
  ASSERT_TRUE(near);
  EXPECT_NEAR(near->distance2, std::pow(std::log(3.3 / 3.0) / params_.range_sigma, 2), 1e-6);
}

TEST_F(BoxGateTest, ACutBoxIsComparedByTheEdgeThatShows) {
  const double edge = 3.0 * 320.0 / 400.0;  // [m] right, where the image ends at 3 m
  const Eigen::Vector3d half_out(edge, 0.0, 3.0);
  const auto match = Match(BoxOf(half_out), ObjectAt(half_out));
  ASSERT_TRUE(match);
  EXPECT_NEAR(match->distance2, 0.0, 1e-9);
  EXPECT_FALSE(Match(BoxOf(half_out), ObjectAt({edge - 1.2, 0.0, 3.0})));
}

TEST_F(BoxGateTest, ABoxCutAtAllEndsShowsNothing) {
  const ReadDetection all =
      Read({.u = 320, .v = 240, .w = 640, .h = 480, .confidence = 0.9, .color = "yellow"});
  EXPECT_FALSE(Match(all, ObjectAt({0.0, 0.0, 3.0})));
}

TEST_F(BoxGateTest, NothingBehindTheCameraIsSeen) {
  EXPECT_FALSE(Match(BoxOf({0.0, 0.0, 3.0}), ObjectAt({0.0, 0.0, -3.0})));
}

TEST_F(BoxGateTest, ADoubtfulDetectionIsLessPrecise) {
  const ExpectedObject object = ObjectAt({0.0, 0.0, 3.0});
  EXPECT_LT(
      Match(BoxOf({0.6, 0.0, 3.0}, 0.5), object).value_or(BoxMatch{.distance2 = 99.0}).distance2,
      Match(BoxOf({0.6, 0.0, 3.0}, 1.0), object).value_or(BoxMatch{.distance2 = 99.0}).distance2 +
          1e-9);
}

}  // namespace
}  // namespace limpet
