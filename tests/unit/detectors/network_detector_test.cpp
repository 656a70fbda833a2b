// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/detectors/sea_scene.hpp"

namespace limpet {
namespace {

using sea_scene::Ball;
using sea_scene::kDepth;

sea_scene::SeaScene NetworkOver(const std::string& seabed, double visibility_m = 8.0) {
  return {"network", seabed, visibility_m};
}

class NetworkOn : public testing::TestWithParam<std::string> {};

TEST_P(NetworkOn, EverySeabedFindsBallsAndCallsThemByTheirNames) {
  auto scene = NetworkOver(GetParam());
  const auto boxes = scene.Find({Ball(0.6, -0.9, 0.3, "yellow"), Ball(-0.5, 0.8, 0.25, "red")});
  ASSERT_GE(boxes.size(), 2U);
  for (const Box& box : {boxes[0], boxes[1]}) {
    EXPECT_GT(box.confidence, 0.45);
    const bool is_yellow = box.u < 320.0;
    EXPECT_EQ(box.color, is_yellow ? "yellow" : "red");
    EXPECT_NEAR(box.u, is_yellow ? 196.0 : 428.0, 20.0);
  }
}
INSTANTIATE_TEST_SUITE_P(Kinds, NetworkOn, testing::Values("sand", "gravel", "rock", "mixed"),
                         [](const auto& kind) { return kind.param; });

TEST(NetworkDetector, PutsABoxWhereTheOutlineIs) {
  auto scene = NetworkOver("sand");
  const auto boxes = scene.Find({Ball(0.4, -0.6, 0.3, "orange")}, 3.0);
  ASSERT_FALSE(boxes.empty());
  const PixelRect& truth = scene.renderer->labels().front().outline;
  EXPECT_NEAR(boxes[0].u, truth.center_u(), 1.0);
  EXPECT_NEAR(boxes[0].v, truth.center_v(), 1.0);
  EXPECT_NEAR(boxes[0].w, truth.width(), 2.0);
  EXPECT_NEAR(boxes[0].h, truth.height(), 2.0);
}

TEST(NetworkDetector, FindsABallThatTheBorderCuts) {
  auto scene = NetworkOver("sand");
  const auto boxes = scene.Find({Ball(0.0, 2.0, 0.35, "orange")}, 3.0);
  ASSERT_FALSE(boxes.empty());
  const SolidLabel& truth = scene.renderer->labels().front();
  EXPECT_LT(truth.visible.area(), 0.9 * truth.outline.area());
  EXPECT_NEAR(boxes[0].u + 0.5 * boxes[0].w, 640.0, 3.0);
  EXPECT_NEAR(boxes[0].v, truth.visible.center_v(), 4.0);
}

TEST(NetworkDetector, SaysTheSameOfTheSamePicture) {
  auto scene = NetworkOver("gravel");
  const std::vector<Solid> balls{Ball(0.5, -0.5, 0.3, "yellow"), Ball(-0.4, 0.6, 0.3, "green")};
  const auto once = scene.Find(balls);
  static_cast<void>(scene.Find({Ball(0.0, 0.0, 0.4, "red")}));
  const auto again = scene.Find(balls);
  ASSERT_EQ(once.size(), again.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].u, again[i].u);
    EXPECT_EQ(once[i].confidence, again[i].confidence);
  }
}

TEST(NetworkDetector, TakesNoOtherFormForABall) {
  auto scene = NetworkOver("sand");
  Solid box{.kind = SolidKind::kBox,
            .p_W = {0.5, 0.5, kDepth - 0.2},
            .radius = 0.25,
            .height = 0.4,
            .color = "yellow"};
  Solid can{.kind = SolidKind::kCylinder,
            .p_W = {-0.6, -0.7, kDepth - 0.15},
            .radius = 0.1,
            .height = 0.6,
            .color = "orange"};
  can.R_WS = Eigen::AngleAxisd(1.57, Eigen::Vector3d::UnitX()).toRotationMatrix();
  for (const Box& found : scene.Find({box, can}))
    EXPECT_LT(found.confidence, 0.45) << found.color;
}

TEST(NetworkDetector, IsLessSureBehindMoreWater) {
  const std::vector<Solid> balls{Ball(0.0, 0.0, 0.3, "orange")};
  const auto clear = NetworkOver("sand", 10.0).Find(balls, 4.0);
  const auto murky = NetworkOver("sand", 2.2).Find(balls, 4.0);
  ASSERT_FALSE(clear.empty());
  EXPECT_GT(clear[0].confidence, murky.empty() ? 0.0 : murky[0].confidence);
}

}  // namespace
}  // namespace limpet
