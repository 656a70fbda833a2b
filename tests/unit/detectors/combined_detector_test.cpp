// SPDX-License-Identifier: MIT
#include "limpet/detectors/combined_detector.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/config.hpp"
#include "limpet/objects/pixel_rect.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/detectors/sea_scene.hpp"

namespace limpet {
namespace {

using sea_scene::Ball;
using sea_scene::SeaScene;

class CombinedOn : public testing::TestWithParam<std::string> {};

TEST_P(CombinedOn, EverySeabedFindsBallsAndCallsThemByTheirNames) {
  SeaScene scene("combined", GetParam());
  const auto boxes = scene.Find({Ball(0.6, -0.9, 0.3, "yellow"), Ball(-0.5, 0.8, 0.25, "red")});
  ASSERT_GE(boxes.size(), 2U);
  for (const Box& box : {boxes[0], boxes[1]}) {
    EXPECT_GT(box.confidence, 0.45);
    EXPECT_EQ(box.color, box.u < 320.0 ? "yellow" : "red");
  }
}
INSTANTIATE_TEST_SUITE_P(Kinds, CombinedOn, testing::Values("sand", "gravel", "rock", "mixed"),
                         [](const auto& kind) { return kind.param; });

TEST(CombinedDetector, SaysOnceWhatBothSee) {
  SeaScene scene("combined", "sand");
  const Image picture = scene.Take({Ball(0.4, -0.6, 0.3, "orange")});
  const PixelRect truth = scene.renderer->labels().front().outline;
  CombinedDetector detector(CombinedDetector::Params{});
  int there = 0;
  for (const WitnessedProposal& proposal : detector.Propose(picture.view())) {
    if (Overlap(RectOf(proposal.network.box), truth) < 0.5) continue;
    ++there;
    EXPECT_TRUE(proposal.shape.has_value());
    EXPECT_TRUE(proposal.is_of_network);
  }
  EXPECT_EQ(there, 1);
}

TEST(CombinedDetector, AsksANetworkThatSaysNoWhereThereIsNothing) {
  SeaScene scene("network", "sand");
  const Image picture = scene.Take({Ball(0.4, -0.6, 0.3, "orange")});
  NetworkDetector network(NetworkDetector::Params{});
  const auto proposals = network.Propose(picture.view());
  ASSERT_FALSE(proposals.empty());
  Box ball;
  SetRect(scene.renderer->labels().front().outline, ball);
  ball.color = proposals.front().box.color;
  Box ground{.u = 520.0, .v = 400.0, .w = ball.w, .h = ball.h, .color = "orange"};
  const NetworkProposal of_ball = network.Weigh(picture.view(), ball);
  const NetworkProposal of_ground = network.Weigh(picture.view(), ground);
  EXPECT_GT(of_ball.score_logit, 0.0);
  EXPECT_LT(of_ground.score_logit, -2.0);
  EXPECT_EQ(of_ground.box.u, ground.u) << "whose box it is, is not asked";
  EXPECT_NE(of_ball.color_logit, 0.0);
  ball.color = "no colour that it has named";
  EXPECT_EQ(network.Weigh(picture.view(), ball).color_logit, -of_ball.color_logit);
}

TEST(CombinedDetector, BelievesABallMoreThatBothSee) {
  const NetworkProposal network{.box = {.u = 100, .v = 100, .w = 40, .h = 40, .color = "orange"},
                                .score_logit = 0.5,
                                .color_logit = 1.0,
                                .roundness = 0.5};
  const WitnessFeatures alone = FeaturesOf({.network = network, .shape = {}});
  Box shape = network.box;
  shape.confidence = 0.9;
  const WitnessFeatures both = FeaturesOf({.network = network, .shape = shape});
  EXPECT_EQ(alone.shape_found, 0.0);
  EXPECT_EQ(both.shape_found, 1.0);
  EXPECT_NEAR(both.shape, std::log(9.0), 1e-9);
  EXPECT_EQ(both.score, alone.score);
  const auto weights = NetworkDescription::Read(FindNetwork("balls.yaml")).witnesses;
  ASSERT_TRUE(weights.has_value());
  EXPECT_GT(weights->shape_found + weights->per_shape * both.shape, 0.5);
}

TEST(CombinedDetector, TakesASilentNetworkForNoSurerThanThat) {
  NetworkProposal silent;
  silent.score_logit = -40.0;
  EXPECT_GT(FeaturesOf({.network = silent, .shape = {}}).score, -10.0);
}

TEST(CombinedDetector, IsRefusedWithANetworkThatWasCalibratedAlone) {
  const TemporaryFolder folder;
  const auto shipped = NetworkDescription::Read(FindNetwork("balls.yaml"));
  std::filesystem::copy_file(shipped.weights, folder.path() / "balls.onnx");
  std::ifstream from(FindNetwork("balls.yaml"));
  std::ofstream to(folder.path() / "alone.yaml");
  for (std::string line; std::getline(from, line);) {
    if (!line.starts_with("witnesses_")) to << line << '\n';
  }
  to.close();
  CombinedDetector::Params params;
  params.network = (folder.path() / "alone.yaml").string();
  try {
    const CombinedDetector detector(params);
    FAIL() << "no complaint";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("alone.yaml"));
    EXPECT_THAT(error.what(), testing::HasSubstr("witnesses_offset"));
    EXPECT_THAT(error.what(), testing::HasSubstr("color_shape"));
  }
}

}  // namespace
}  // namespace limpet
