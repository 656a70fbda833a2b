// SPDX-License-Identifier: MIT
#include <memory>

#include <gtest/gtest.h>

#include "limpet/objects/pixel_rect.hpp"
#include "limpet/vision/detector_registry.hpp"
#include "tests/support/detector_trial.hpp"

namespace limpet {
namespace {

struct Scene {
  SceneRenderer renderer;
  std::unique_ptr<Detector> detector = MakeDetector("color_shape");

  explicit Scene(double visibility_m = 8.0)
      : renderer({.camera = {},
                  .seabed_depth = [](const Eigen::Vector2d&) { return 7.5; },
                  .visibility_m = visibility_m,
                  .seabed_seed = 2,
                  .noise_seed = 3}) {}
  std::vector<Box> Find(const std::vector<Sphere>& spheres, double altitude = 4.0) {
    Pose pose;
    pose.p_WB = {0.0, 0.0, 7.5 - altitude};
    return detector->Detect(renderer.Render(pose, spheres, 0).view());
  }
};

SphereImage TruthOf(const Sphere& sphere, double altitude = 4.0) {
  Pose pose;
  pose.p_WB = {0.0, 0.0, 7.5 - altitude};
  const CameraModel camera;
  return *ImageOfSphere(camera, camera.InCamera(pose, sphere.p_W), sphere.radius);
}

class PaintTest : public testing::TestWithParam<const char*> {};

TEST_P(PaintTest, IsFoundWithinAPixelAndCalledByItsName) {
  Scene scene;
  const Sphere ball{{0.5, -0.9, 6.5}, 0.4, GetParam()};
  const std::vector<Box> boxes = scene.Find({ball});
  ASSERT_EQ(boxes.size(), 1U);
  const PixelRect truth = TruthOf(ball).visible;
  EXPECT_NEAR(boxes[0].u, truth.center_u(), 1.0);
  // The dim side of a white ball is as bright as sand, which pulls its edge in.
  const double tolerance = GetParam() == std::string("white") ? 1.5 : 1.0;
  EXPECT_NEAR(boxes[0].v, truth.center_v(), tolerance);
  EXPECT_NEAR(boxes[0].w, truth.width(), 2.5);
  EXPECT_NEAR(boxes[0].h, truth.height(), 2.5);
  EXPECT_EQ(boxes[0].color, GetParam());
}
INSTANTIATE_TEST_SUITE_P(AllPaints, PaintTest,
                         testing::Values("yellow", "orange", "red", "green", "white", "blue",
                                         "purple"));

TEST(ColorShapeDetector, BoxOfACutBallEndsAtTheBorder) {
  Scene scene;
  const Sphere ball{{0.0, 2.75, 7.0}, 0.5, "yellow"};
  const SphereImage truth = TruthOf(ball);
  ASSERT_LT(truth.visible_fraction, 0.95);
  const std::vector<Box> boxes = scene.Find({ball});
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_NEAR(boxes[0].u + 0.5 * boxes[0].w, 640.0, 1e-6);
  EXPECT_GT(Overlap(RectOf(boxes[0]), truth.visible), 0.9);
}

class WarmRimTest : public testing::TestWithParam<const char*> {};

TEST_P(WarmRimTest, OfABallThatTheBorderCutsHasTheBallsColour) {
  // From little of it to nearly half, at either border: lit from the north, east and above, the one
  // shows more of its dim side.
  const CameraModel camera;
  int found = 0;
  for (const double visibility_m : {3.0, 6.0, 12.0}) {
    Scene scene(visibility_m);
    for (const double side : {-1.0, 1.0}) {
      for (const double beyond : {-0.1, 0.0, 0.1, 0.2}) {
        const double border = camera.cx / camera.fx * 2.5;
        const Sphere ball{{0.3, side * (border + beyond), 6.0}, 0.5, GetParam()};
        const SphereImage truth = TruthOf(ball);
        for (const Box& box : scene.Find({ball})) {
          if (Overlap(RectOf(box), truth.visible) < 0.4) continue;
          ++found;
          EXPECT_EQ(box.color, GetParam())
              << truth.visible_fraction << " of it at " << visibility_m << " m of visibility";
        }
      }
    }
  }
  EXPECT_GE(found, 12);
}
INSTANTIATE_TEST_SUITE_P(WarmPaints, WarmRimTest, testing::Values("yellow", "orange", "red"));

TEST(ColorShapeDetector, FindsAFaintBallInPoorVisibility) {
  Scene scene(3.0);
  const Sphere ball{{0.2, 0.3, 7.0}, 0.5, "orange"};
  const std::vector<Box> boxes = scene.Find({ball}, 3.0);
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_EQ(boxes[0].color, "orange");
}

TEST(ColorShapeDetector, SeesNothingOnBareSeabed) {
  Scene scene;
  EXPECT_TRUE(scene.Find({}).empty());
  EXPECT_TRUE(scene.Find({}, 2.0).empty());
}

TEST(ColorShapeDetector, FindsNearlyAllBallsAndInventsNearlyNone) {
  const trial::Result result = trial::RunDetector({.scenes = 6, .frames = 40, .seed = 77});
  int seen = 0;
  int found = 0;
  for (const trial::Look& look : result.looks) {
    if (look.image.visible_fraction >= 0.6 && look.range_share() < 1.0) {
      ++seen;
      found += look.found ? 1 : 0;
    }
  }
  ASSERT_GT(seen, 80);
  EXPECT_GE(found, 0.97 * seen);  // 0.98 over thousands; three sigma of this sample
  EXPECT_LE(result.false_boxes, 5);
}

}  // namespace
}  // namespace limpet
