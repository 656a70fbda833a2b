// SPDX-License-Identifier: MIT
// What a box says of the voxels of a sphere, over random spheres and views.
#include "estimation/mapping/object_look.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "limpet/objects/box.hpp"

namespace limpet {
namespace {

TEST(ObjectProbability, IsTheConfidenceInTheMiddleAndAHalfFarOutside) {
  EXPECT_NEAR(ObjectProbability({0.0, 10.0}, 0.8), 0.8, 1e-12);
  EXPECT_NEAR(ObjectProbability({10.0, 10.0}, 0.8), 0.5 + 0.3 * std::exp(-0.5), 1e-12);
  EXPECT_NEAR(ObjectProbability({200.0, 10.0}, 0.8), 0.5, 1e-12);
}

TEST(ObjectProbability, OfNoBoxIsProofOrNothing) {
  EXPECT_NEAR(ObjectProbability({0.0, 10.0}, 1.0), 0.97, 1e-12);
  EXPECT_NEAR(ObjectProbability({0.0, 10.0}, 0.0), 0.55, 1e-12);
}

TEST(ObjectProbability, FallsOutwardsAndNeverSpeaksAgainst) {
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const double s = random.Uniform(1.0, 80.0), confidence = random.Uniform(0.0, 1.0);
    const double near = random.Uniform(0.0, 3.0 * s), far = near + random.Uniform(0.0, s);
    EXPECT_GE(ObjectProbability({near, s}, confidence), ObjectProbability({far, s}, confidence));
    EXPECT_GE(ObjectProbability({far, s}, confidence), 0.5);
  }
}

/// A sphere and a box that shows it, from above.
struct SphereView {
  CameraModel camera;
  ObjectLook look;
  double radius = 0.0;
};

SphereView DrawView(Random& random) {
  SphereView view{.camera = {}, .look = {}, .radius = random.Uniform(0.2, 0.7)};
  Pose& X_WB = view.look.X_WB;
  X_WB = {{random.Normal(10.0), random.Normal(10.0), random.Uniform(1.0, 4.0)},
          random.Uniform(-0.1, 0.1),
          random.Uniform(-0.1, 0.1),
          random.Uniform(-3.1, 3.1)};
  const double depth = random.Uniform(2.0, 5.0);
  const Eigen::Vector3d p_C(depth * random.Uniform(-0.2, 0.2), depth * random.Uniform(-0.15, 0.15),
                            depth);
  view.look.object_W = X_WB.p_WB + RotationOf(X_WB) * (view.camera.R_BC * p_C + view.camera.p_BC);
  const Eigen::Vector2d pixel = *view.camera.Project(p_C);
  view.look.box = {.u = pixel.x(),
                   .v = pixel.y(),
                   .w = 2.0 * view.radius * view.camera.fx / depth,
                   .h = 2.0 * view.radius * view.camera.fy / depth,
                   .confidence = random.Uniform(0.6, 0.95),
                   .color = "yellow"};
  return view;
}

class ObjectLookProperties : public ::testing::TestWithParam<int> {
 protected:
  Random random_{static_cast<std::uint64_t>(GetParam()), "object look"};
};

TEST_P(ObjectLookProperties, TheRadiusOfABoxIsThatOfTheSphere) {
  for (int i = 0; i < 50; ++i) {
    const SphereView view = DrawView(random_);
    EXPECT_NEAR(RadiusFromBox(view.look, view.camera), view.radius, 1e-9);
  }
}

TEST_P(ObjectLookProperties, EveryPointLiesOnTheNearSideOfTheSphere) {
  for (int i = 0; i < 20; ++i) {
    const SphereView view = DrawView(random_);
    const auto points =
        NearSurface(view.look, view.camera, {.radius = view.radius, .spacing = 0.1});
    ASSERT_GT(points.size(), 10U);
    const Eigen::Vector3d origin =
        view.look.X_WB.p_WB + RotationOf(view.look.X_WB) * view.camera.p_BC;
    for (const VoxelEvidence& point : points) {
      EXPECT_NEAR((point.p_W - view.look.object_W).norm(), view.radius, 1e-6);
      EXPECT_LT((point.p_W - origin).norm(), (view.look.object_W - origin).norm());
    }
  }
}

TEST_P(ObjectLookProperties, EvidenceIsGreatestInTheMiddleAndNeverAgainst) {
  for (int i = 0; i < 20; ++i) {
    const SphereView view = DrawView(random_);
    const double most = std::log(view.look.box.confidence / (1.0 - view.look.box.confidence));
    for (const VoxelEvidence& point :
         NearSurface(view.look, view.camera, {.radius = view.radius, .spacing = 0.05})) {
      EXPECT_GE(point.log_odds, 0.0);
      EXPECT_LE(point.log_odds, most + 1e-9);
    }
  }
}

TEST_P(ObjectLookProperties, TheSurfaceLeadsBackToTheCentre) {
  for (int i = 0; i < 20; ++i) {
    const SphereView view = DrawView(random_);
    std::vector<Eigen::Vector3d> points;
    for (const VoxelEvidence& point :
         NearSurface(view.look, view.camera, {.radius = view.radius, .spacing = 0.1}))
      points.push_back(point.p_W);
    const auto centre = SphereCentre(points, view.radius);
    ASSERT_TRUE(centre);
    EXPECT_LT((*centre - view.look.object_W).norm(), 0.01);
  }
}

TEST_P(ObjectLookProperties, WhatLiesOutsideTheImageIsNotSeen) {
  for (int i = 0; i < 20; ++i) {
    SphereView view = DrawView(random_);
    const Pose& X_WB = view.look.X_WB;
    const auto whole = NearSurface(view.look, view.camera, {.radius = view.radius, .spacing = 0.1});
    view.camera.width_px = static_cast<int>(view.look.box.u);  // half of the box is left
    const auto half = NearSurface(view.look, view.camera, {.radius = view.radius, .spacing = 0.1});
    EXPECT_NEAR(static_cast<double>(half.size()) / static_cast<double>(whole.size()), 0.5, 0.15);
    for (const VoxelEvidence& point : half) {
      const auto pixel = view.camera.Project(view.camera.InCamera(X_WB, point.p_W));
      ASSERT_TRUE(pixel);
      EXPECT_LE(pixel->x(), view.camera.width_px + 1e-6);
    }
  }
}

TEST_P(ObjectLookProperties, ACutBoxIsMendedToTheWholeOne) {
  const CameraModel camera;
  for (int i = 0; i < 50; ++i) {
    // A sphere is as wide as high but for the focal lengths.
    const double height = random_.Uniform(60.0, 160.0), size = height * camera.fx / camera.fy;
    const double off = random_.Uniform(-0.3, 0.3) * size;
    const double v = random_.Uniform(150.0, 330.0);
    // The left border leaves what is beyond it out.
    const double right = off + 0.5 * size;
    const Box cut{.u = 0.5 * right, .v = v, .w = right, .h = height, .color = "yellow"};
    const Box whole = WholeBox(cut, {0.5 * size, 0.5 * size}, camera);
    EXPECT_NEAR(whole.u, off, 1e-9);
    EXPECT_NEAR(whole.w, size, 1e-9);
    EXPECT_EQ(whole.v, v);
    EXPECT_EQ(whole.h, height);
  }
}

TEST_P(ObjectLookProperties, ABoxInACornerIsMendedByTheObjectsSizeAlone) {
  const CameraModel camera;
  for (int i = 0; i < 50; ++i) {
    const double size = random_.Uniform(60.0, 160.0), shown = random_.Uniform(0.3, 0.9) * size;
    const Box cut{.u = camera.width_px - 0.5 * shown,
                  .v = camera.height_px - 0.5 * shown,
                  .w = shown,
                  .h = shown,
                  .color = "yellow"};
    const Box whole = WholeBox(cut, {0.5 * size, 0.5 * size}, camera);
    EXPECT_NEAR(whole.u, camera.width_px - shown + 0.5 * size, 1e-9);
    EXPECT_NEAR(whole.v, camera.height_px - shown + 0.5 * size, 1e-9);
    EXPECT_NEAR(whole.w, size, 1e-9);
    EXPECT_NEAR(whole.h, size, 1e-9);
  }
}

TEST_P(ObjectLookProperties, AWholeBoxStaysAsItIs) {
  const CameraModel camera;
  for (int i = 0; i < 50; ++i) {
    const Box box{.u = random_.Uniform(200.0, 400.0),
                  .v = random_.Uniform(180.0, 300.0),
                  .w = random_.Uniform(10.0, 300.0),
                  .h = random_.Uniform(10.0, 300.0),
                  .color = "green"};
    const Box whole = WholeBox(box, {50.0, 50.0}, camera);
    EXPECT_EQ(whole.u, box.u);
    EXPECT_EQ(whole.v, box.v);
    EXPECT_EQ(whole.w, box.w);
    EXPECT_EQ(whole.h, box.h);
  }
}

TEST_P(ObjectLookProperties, ACentreIsFoundInSpiteOfNoise) {
  for (int i = 0; i < 10; ++i) {
    const Eigen::Vector3d truth(random_.Normal(10.0), random_.Normal(10.0), 6.0);
    const double radius = random_.Uniform(0.3, 0.8);
    std::vector<Eigen::Vector3d> points;
    for (int k = 0; k < 120; ++k) {
      const double azimuth = random_.Uniform(0.0, 2.0 * std::numbers::pi);
      const double polar = random_.Uniform(0.0, 1.2);  // of the upper side
      const Eigen::Vector3d outward(std::sin(polar) * std::cos(azimuth),
                                    std::sin(polar) * std::sin(azimuth), -std::cos(polar));
      points.emplace_back(truth + (radius + random_.Normal(0.03)) * outward);
    }
    const auto centre = SphereCentre(points, radius);
    ASSERT_TRUE(centre);
    EXPECT_LT((*centre - truth).norm(), 0.05);
  }
}

INSTANTIATE_TEST_SUITE_P(Drawn, ObjectLookProperties, ::testing::Range(1, 6));

TEST(SphereCentre, IsNoneOfThreePointsOrOfPointsOfNoSphere) {
  EXPECT_FALSE(SphereCentre({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 0.5));
}

}  // namespace
}  // namespace limpet
