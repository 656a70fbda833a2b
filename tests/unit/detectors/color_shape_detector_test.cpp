// SPDX-License-Identifier: MIT
#include <cmath>
#include <memory>
#include <string>
#include <vector>

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

/// A ball above the seabed whose centre is about on the left or the right border of the image.
Sphere BallAtTheBorder(const Pose& pose, const std::string& color, Random& random) {
  const CameraModel camera;
  const double below = 7.5 - pose.p_WB.z() - random.Uniform(0.5, 1.0);
  const double side = random.Chance(0.5) ? 1.0 : -1.0;
  const double right = side * (camera.cx / camera.fx * below + random.Uniform(0.1, 0.4));
  const double ahead = 0.6 * below * random.Uniform(-1.0, 1.0);
  const double c = std::cos(pose.yaw), s = std::sin(pose.yaw);
  return {{pose.p_WB.x() + c * ahead - s * right, pose.p_WB.y() + s * ahead + c * right,
           pose.p_WB.z() + below},
          0.5,
          color};
}

class WarmRimTest : public testing::TestWithParam<const char*> {};

TEST_P(WarmRimTest, OfABallThatTheBorderCutsHasTheBallsColour) {
  // On any course: one rim is in the light, the next in the shade.
  Random random(71, "rims");
  int found = 0, wrong = 0;
  for (const double visibility_m : {5.0, 10.0}) {
    Scene scene(visibility_m);
    for (int i = 0; i < 40; ++i) {
      const Pose pose = trial::RandomPose(random);
      const Sphere ball = BallAtTheBorder(pose, GetParam(), random);
      const CameraModel camera;
      const auto truth = ImageOfSphere(camera, camera.InCamera(pose, ball.p_W), ball.radius);
      if (!truth) continue;
      const Image image = scene.renderer.Render(pose, std::vector<Sphere>{ball}, 0);
      for (const Box& box : scene.detector->Detect(image.view())) {
        if (Overlap(RectOf(box), truth->visible) < 0.4) continue;
        ++found;
        wrong += box.color == GetParam() ? 0 : 1;
      }
    }
  }
  EXPECT_GE(found, 20);
  EXPECT_EQ(wrong, 0);
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
