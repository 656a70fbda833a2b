// SPDX-License-Identifier: MIT
// What every registered detector owes to whoever runs it, whatever it looks for.
#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/objects/pixel_rect.hpp"
#include "limpet/vision/detector_registry.hpp"
#include "limpet/vision/scene_renderer.hpp"

namespace limpet {
namespace {

class EveryDetector : public testing::TestWithParam<std::string> {
 protected:
  std::vector<Box> Find(const std::vector<Sphere>& balls, double altitude = 4.0) {
    return detector_->Detect(Picture(balls, altitude).view());
  }
  Image Picture(const std::vector<Sphere>& balls, double altitude) {
    Pose pose;
    pose.p_WB = {0.0, 0.0, 7.5 - altitude};
    return renderer_.Render(pose, balls, 0);
  }
  SceneRenderer renderer_{{.camera = {},
                           .seabed_depth = [](const Eigen::Vector2d&) { return 7.5; },
                           .visibility_m = 8.0,
                           .seabed_seed = 2,
                           .noise_seed = 3}};
  std::unique_ptr<Detector> detector_ = MakeDetector(GetParam());
};

const std::vector<Sphere> kThreeBalls{{{0.3, 0.4, 7.0}, 0.5, "yellow"},
                                      {{-0.8, -1.0, 6.0}, 0.3, "red"},
                                      {{0.0, 2.75, 7.0}, 0.5, "orange"}};

TEST_P(EveryDetector, ForgetsTheFormerImage) {
  const std::vector<Box> first = Find(kThreeBalls);
  static_cast<void>(Find({{{-0.5, 0.2, 6.0}, 0.4, "red"}}, 2.5));
  const std::vector<Box> again = Find(kThreeBalls);
  ASSERT_EQ(first.size(), again.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].u, again[i].u);
    EXPECT_EQ(first[i].w, again[i].w);
    EXPECT_EQ(first[i].confidence, again[i].confidence);
  }
}

TEST_P(EveryDetector, NamesTheMostConfidentFirstAndNothingOutsideTheImage) {
  const std::vector<Box> boxes = Find(kThreeBalls);
  EXPECT_TRUE(std::ranges::is_sorted(boxes, std::ranges::greater(), &Box::confidence));
  for (const Box& box : boxes) {
    const PixelRect rect = RectOf(box);
    EXPECT_GE(rect.left, -1e-9);
    EXPECT_GE(rect.top, -1e-9);
    EXPECT_LE(rect.right, 640.0 + 1e-9);
    EXPECT_LE(rect.bottom, 480.0 + 1e-9);
    EXPECT_GT(box.confidence, 0.0);
    EXPECT_LE(box.confidence, 1.0);
  }
}

TEST_P(EveryDetector, FindsNothingInABlankImageOfAnySize) {
  for (const int side : {0, 1, 31, 33, 101}) {
    const Image image{side, side,
                      std::vector<std::uint8_t>(3U * static_cast<unsigned>(side * side), 90)};
    EXPECT_TRUE(detector_->Detect(image.view()).empty()) << side;
  }
}

TEST_P(EveryDetector, LeavesTheImageAlone) {
  const Image image = Picture(kThreeBalls, 4.0);
  const Image before = image;
  static_cast<void>(detector_->Detect(image.view()));
  EXPECT_EQ(image.bgr, before.bgr);
}

/// All but the one that detector_registry_test.cpp makes up.
std::vector<std::string> ShippedDetectors() {
  std::vector<std::string> names = DetectorNames();
  std::erase(names, "whole_image");
  return names;
}

INSTANTIATE_TEST_SUITE_P(Registered, EveryDetector, testing::ValuesIn(ShippedDetectors()),
                         [](const auto& name) { return name.param; });

}  // namespace
}  // namespace limpet
