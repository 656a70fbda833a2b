// SPDX-License-Identifier: MIT
// What must hold of the gate between a box and an object, wherever both are.
#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "estimation/association/box_gate.hpp"
#include "tests/unit/association/association_draws.hpp"

namespace limpet {
namespace {

constexpr int kGateCases = 300;
constexpr double kNoGate = 1e9;

/// A pose, an object of which it is jointly uncertain, and a box near where it should appear.
struct GateCase {
  NavVector x;
  ExpectedObject object;
  ReadDetection seen;
};

class BoxGateProperties : public ::testing::Test {
 protected:
  [[nodiscard]] ReadDetection Read(const Box& box) const {
    return {box, ReadBox(box, camera_, BoxNoise{})};
  }
  /// The box is that of a sphere up to `off` from the object [m].
  [[nodiscard]] GateCase Draw(Random& random, double off, double doubt = 0.3) const {
    GateCase drawn;
    drawn.x = DrawPose(random);
    const Eigen::Vector3d p_C = DrawPointInView(random);
    drawn.object = {.p_W = InWorld(camera_, drawn.x, p_C),
                    .radius = 0.5,
                    .color = "yellow",
                    .covariance = DrawCovariance<9>(random, doubt)};
    const Eigen::Vector3d away(random.Normal(off), random.Normal(off), random.Normal(0.3 * off));
    std::optional<Box> box = BoxFrom(camera_, drawn.x, drawn.object.p_W + away);
    while (!box)
      box = BoxFrom(camera_, drawn.x, drawn.object.p_W + random.Uniform(0.0, 0.5) * away);
    drawn.seen = Read(*box);
    return drawn;
  }
  [[nodiscard]] std::optional<BoxMatch> Match(const GateCase& c,
                                              const BoxGateParams& params = {}) const {
    return BoxGate(camera_, params).Match(c.seen, c.x, c.object);
  }
  /// A certain pose over an object on the optical axis, 3 m below; the box is read exactly there.
  [[nodiscard]] GateCase OnTheAxis() const {
    GateCase c;
    c.x = NavVector::Zero();
    c.object = {.p_W = {0.0, 0.0, 3.0},
                .radius = 0.5,
                .color = "yellow",
                .covariance = PoseObjectCovariance::Zero()};
    c.seen = Read(*BoxFrom(camera_, c.x, c.object.p_W));
    return c;
  }

  const CameraModel camera_{};
};

TEST_F(BoxGateProperties, WhateverItSaysIsANumberWithinTheGate) {
  Random random(11);
  int matches = 0;
  for (int i = 0; i < kGateCases; ++i) {
    const auto match = Match(Draw(random, 0.6, 0.2));
    if (!match) continue;
    ++matches;
    EXPECT_TRUE(std::isfinite(match->cost)) << i;
    EXPECT_TRUE(std::isfinite(match->new_cost)) << i;
    EXPECT_GT(match->spread_px, 0.0) << i;
    EXPECT_GE(match->distance2, 0.0) << i;
    EXPECT_LE(match->distance2, BoxGateParams{}.chi2_per_gate) << i;
  }
  EXPECT_GT(matches, kGateCases / 4);
  EXPECT_LT(matches, kGateCases) << "else the gate was not tried";
}

TEST_F(BoxGateProperties, AWorldTurnedAndMovedWithItsVehicleMatchesAlike) {
  Random random(12);
  for (int i = 0; i < kGateCases; ++i) {
    const GateCase here = Draw(random, 0.4);
    const WorldChange change = DrawWorldChange(random);
    GateCase there = here;
    there.x = change.ApplyToPose(here.x);
    there.object.p_W = change.Apply(here.object.p_W);
    there.object.covariance = change.ApplyToCovariance(here.object.covariance);
    const BoxGateParams open{.chi2_per_gate = kNoGate, .overlap_share = 0.0};
    const auto a = Match(here, open), b = Match(there, open);
    ASSERT_TRUE(a && b) << i;
    EXPECT_NEAR(a->distance2, b->distance2, 1e-6 * (1.0 + a->distance2)) << i;
    EXPECT_NEAR(a->cost, b->cost, 1e-6 * (1.0 + a->cost)) << i;
    EXPECT_NEAR(a->spread_px, b->spread_px, 1e-6 * a->spread_px) << i;
  }
}

TEST_F(BoxGateProperties, MoreDoubtNeverPutsABoxFurtherAway) {
  Random random(13);
  for (int i = 0; i < kGateCases; ++i) {
    const GateCase sure = Draw(random, 0.5, 0.1);
    GateCase doubtful = sure;
    doubtful.object.covariance += DrawCovariance<9>(random, 0.2);
    const auto a = Match(sure), b = Match(doubtful);
    if (!a) continue;
    ASSERT_TRUE(b) << "a box that fits a sure place fits a doubtful one, case " << i;
    EXPECT_LE(b->distance2, a->distance2 + 1e-9) << i;
    EXPECT_GE(b->spread_px, a->spread_px) << i;
  }
}

TEST_F(BoxGateProperties, ADetectorThatIsLessSureOfItsBoxNeverPutsItFurtherAway) {
  Random random(14);
  for (int i = 0; i < kGateCases; ++i) {
    GateCase sure = Draw(random, 0.3);
    GateCase unsure = sure;
    unsure.seen.box.confidence = random.Uniform(0.0, 0.85);
    unsure.seen = Read(unsure.seen.box);
    const auto a = Match(sure), b = Match(unsure);
    if (!a) continue;
    ASSERT_TRUE(b) << i;
    EXPECT_LE(b->distance2, a->distance2 + 1e-9) << i;
  }
}

TEST_F(BoxGateProperties, TheGateClosesAtItsDistanceAndNotBefore) {
  Random random(15);
  for (int i = 0; i < kGateCases; ++i) {
    const GateCase c = Draw(random, 0.6);
    const auto open = Match(c, {.chi2_per_gate = kNoGate, .overlap_share = 0.0});
    ASSERT_TRUE(open) << i;
    const double d2 = open->distance2;
    EXPECT_TRUE(Match(c, {.chi2_per_gate = d2 * (1.0 + 1e-9), .overlap_share = 0.0})) << i;
    EXPECT_FALSE(Match(c, {.chi2_per_gate = d2 * (1.0 - 1e-9), .overlap_share = 0.0})) << i;
  }
}

TEST_F(BoxGateProperties, ABoxOnAnObjectMayAlwaysBeItsUpToTheShareOfOverlap) {
  // A gate that knows of no error but the reading's would refuse what is 50 px off.
  BoxGateParams strict;
  strict.model_error_px = strict.model_error_share = 0.0;
  for (const double side : {-1.0, 1.0}) {
    for (const int axis : {0, 1}) {
      GateCase c = OnTheAxis();
      const double f = axis == 0 ? camera_.fx : camera_.fy;
      const double size = 2.0 * f * std::tan(std::asin(0.5 / 3.0));
      const double expected = c.seen.reading.centre_px(axis);
      c.seen.reading.centre_px(axis) = expected + side * (strict.overlap_share * size - 0.01);
      const auto inside = Match(c, strict);
      ASSERT_TRUE(inside) << "axis " << axis << ", side " << side;
      EXPECT_LT(inside->distance2, strict.chi2_per_gate);
      c.seen.reading.centre_px(axis) = expected + side * (strict.overlap_share * size + 0.01);
      EXPECT_FALSE(Match(c, strict)) << "axis " << axis << ", side " << side;
    }
  }
}

TEST_F(BoxGateProperties, ASphereTooLargeOrTooSmallByTheGateIsAnotherOne) {
  const BoxGateParams params;
  const double edge = std::sqrt(params.chi2_per_gate) * params.range_sigma;
  for (const double sign : {-1.0, 1.0}) {
    for (const double beyond : {-0.001, 0.001}) {
      GateCase c = OnTheAxis();
      const double range = 3.0 * std::exp(sign * (edge + beyond));
      c.seen.reading.half_angle.setConstant(std::asin(0.5 / range));
      EXPECT_EQ(Match(c).has_value(), beyond < 0.0) << "a range of " << range << " m";
    }
  }
}

TEST_F(BoxGateProperties, AnObjectNearerThanThirtyCentimetresToTheCameraHasNoBox) {
  for (const double depth : {0.299, 0.301}) {
    GateCase c = OnTheAxis();
    c.object.p_W.z() = depth;
    c.object.radius = 0.05;
    c.seen.reading.half_angle.setConstant(std::asin(0.05 / depth));
    EXPECT_EQ(Match(c).has_value(), depth > 0.3) << depth;
  }
}

TEST_F(BoxGateProperties, TheMirrorImageOfASceneMatchesAlike) {
  Random random(16);
  for (int i = 0; i < kGateCases; ++i) {
    const Eigen::Vector3d p_C = DrawPointInView(random);
    const Eigen::Vector3d q_C = p_C + Eigen::Vector3d(random.Normal(0.2), random.Normal(0.2), 0.0);
    const auto of = [&](double side) {
      const auto mirror = [side](Eigen::Vector3d p) {
        p.x() *= side;
        return p;
      };
      GateCase c = OnTheAxis();
      c.object.p_W = InWorld(camera_, c.x, mirror(p_C));
      c.seen = Read(*BoxFrom(camera_, c.x, InWorld(camera_, c.x, mirror(q_C))));
      return Match(c, {.chi2_per_gate = kNoGate});
    };
    const auto right = of(1.0), left = of(-1.0);
    ASSERT_TRUE(right && left) << i;
    EXPECT_NEAR(right->cost, left->cost, 1e-6 * (1.0 + std::abs(right->cost))) << i;
  }
}

TEST_F(BoxGateProperties, WhichClassIsConfusedWithWhichDoesNotMatter) {
  Random random(17);
  for (int i = 0; i < kGateCases; ++i) {
    GateCase c = Draw(random, 0.1);
    const auto cost = [&](const char* object, const char* box) {
      c.object.color = object;
      c.seen.box.color = box;
      const auto match = Match(c, {.chi2_per_gate = kNoGate});
      return match ? match->cost : -1e9;
    };
    EXPECT_EQ(cost("red", "blue"), cost("blue", "red"));
    EXPECT_EQ(cost("red", "red"), cost("blue", "blue"));
    EXPECT_GT(cost("red", "blue"), cost("red", "red"));
  }
}

TEST_F(BoxGateProperties, SomethingNewIsAsLikelyWhereverTheObjectIsExpected) {
  Random random(18);
  const Box box = *BoxFrom(camera_, NavVector::Zero(), {0.2, 0.1, 3.0});
  std::optional<double> first;
  for (int i = 0; i < kGateCases; ++i) {
    GateCase c = Draw(random, 0.1);
    c.seen = Read(box);
    const auto match = Match(c, {.chi2_per_gate = kNoGate});
    if (!match) continue;
    if (!first) first = match->new_cost;
    EXPECT_EQ(match->new_cost, *first);
  }
  EXPECT_TRUE(first);
}

TEST_F(BoxGateProperties, AnAxisThatTheBorderCutsTwiceTellsNothingOfTheObject) {
  // The box spans the whole width: only how far up it is counts.
  GateCase c = OnTheAxis();
  c.seen = Read({.u = 320, .v = 240, .w = 640, .h = 140, .confidence = 0.85, .color = "yellow"});
  const auto middle = Match(c);
  ASSERT_TRUE(middle);
  for (const double starboard : {-1.2, -0.4, 0.7, 1.5}) {
    c.object.p_W.y() = starboard;
    const auto aside = Match(c);
    ASSERT_TRUE(aside) << starboard;
    EXPECT_NEAR(aside->distance2, middle->distance2, 1e-9) << starboard;
    EXPECT_EQ(aside->new_cost, middle->new_cost) << starboard;
  }
  EXPECT_NEAR(middle->new_cost, -2.0 * std::log(0.1 / 480.0), 1e-9);
}

TEST_F(BoxGateProperties, AnyBoxAtAllGetsAnAnswer) {
  Random random(19);
  for (int i = 0; i < kGateCases; ++i) {
    GateCase c;
    c.x = DrawPose(random);
    c.object = {.p_W = c.x.head<3>() +
                       Eigen::Vector3d(random.Normal(6.0), random.Normal(6.0), random.Normal(6.0)),
                .radius = random.Uniform(0.0, 3.0),
                .color = "yellow",
                .covariance = DrawCovariance<9>(random, random.Uniform(0.001, 20.0))};
    c.seen = Read({.u = random.Uniform(0.0, 640.0),
                   .v = random.Uniform(0.0, 480.0),
                   .w = random.Uniform(0.0, 900.0),
                   .h = random.Uniform(0.0, 900.0),
                   .confidence = random.Uniform(-0.5, 1.5),
                   .color = "yellow"});
    const auto match = Match(c, {.chi2_per_gate = kNoGate});
    if (!match) continue;
    EXPECT_TRUE(std::isfinite(match->cost)) << i;
    EXPECT_TRUE(std::isfinite(match->distance2)) << i;
    EXPECT_GE(match->distance2, -1e-9) << i;
    EXPECT_TRUE(std::isfinite(match->spread_px)) << i;
  }
}

}  // namespace
}  // namespace limpet
