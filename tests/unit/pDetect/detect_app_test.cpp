// SPDX-License-Identifier: MIT
#include "apps/pDetect/detect_app.hpp"

#include <gtest/gtest.h>

#include "limpet/core/config.hpp"
#include "limpet/topics/chips.hpp"
#include "limpet/vision/scene_renderer.hpp"
#include "tests/support/test_link.hpp"

namespace limpet {
namespace {

CameraFrame Picture(const std::vector<Sphere>& spheres) {
  static SceneRenderer renderer({.camera = {},
                                 .seabed_depth = [](const Eigen::Vector2d&) { return 7.5; },
                                 .visibility_m = 8.0,
                                 .seabed_seed = 1,
                                 .noise_seed = 2});
  Pose pose;
  pose.p_WB = {0.0, 0.0, 3.5};
  Image image = renderer.Render(pose, spheres, 0);
  return {.frame = 17,
          .exposure = Seconds(1767225600.25),
          .width_px = image.width_px,
          .height_px = image.height_px,
          .bgr = std::move(image.bgr)};
}

const std::vector<Sphere> kBalls{{{0.4, 0.8, 7.0}, 0.5, "yellow"}, {{-0.6, -1.0, 7.0}, 0.5, "red"}};

class Detect : public testing::Test {
 protected:
  std::optional<Detections> Run(const DetectApp::Params& params, const std::vector<Sphere>& balls) {
    AppContext context;
    context.name = "pDetect";
    context.link = &link_;
    DetectApp app(context, params, MakeDetector(params.detector));
    link_.Send(app, topics::kCameraFrame, Picture(balls));
    return link_.Last(topics::kDetections);
  }
  TestLink link_;
};

TEST_F(Detect, NamesFrameAndExposureOfTheImage) {
  const auto detections = Run({}, kBalls);
  ASSERT_TRUE(detections);
  EXPECT_EQ(detections->frame, 17);
  EXPECT_EQ(detections->exposure.value(), 1767225600.25);
  EXPECT_EQ(detections->boxes.size(), 2U);
}

TEST_F(Detect, SpeaksAlsoOfEmptyImages) {
  const auto detections = Run({}, {});
  ASSERT_TRUE(detections);
  EXPECT_TRUE(detections->boxes.empty());
}

TEST_F(Detect, ReportsOnlyTheWantedClasses) {
  DetectApp::Params params;
  params.classes = "yellow, green";
  const auto detections = Run(params, kBalls);
  ASSERT_TRUE(detections);
  ASSERT_EQ(detections->boxes.size(), 1U);
  EXPECT_EQ(detections->boxes[0].color, "yellow");
}

TEST_F(Detect, DropsWhatIsNotConfidentEnough) {
  DetectApp::Params params;
  params.min_confidence = 1.0;
  const Sphere faint{{0.0, 3.0, 7.0}, 0.2, "green"};
  const auto detections = Run(params, {faint});
  ASSERT_TRUE(detections);
  EXPECT_TRUE(detections->boxes.empty());
}

TEST_F(Detect, RefusesAClassThatDoesNotExist) {
  DetectApp::Params params;
  params.classes = "yelow";
  EXPECT_THROW(Run(params, {}), ConfigError);
}

TEST_F(Detect, CutsOutWhatItIsSureOfOnceASecondAtMost) {
  AppContext context;
  context.name = "pDetect";
  context.link = &link_;
  DetectApp app(context, {}, MakeDetector("color_shape"));
  CameraFrame frame = Picture(kBalls);
  for (int i = 0; i < 9; ++i) {
    link_.Send(app, topics::kCameraFrame, frame);
    frame.exposure += Seconds(0.25);
  }
  EXPECT_EQ(link_.Count(topics::kDetectionChips), 3);
  const auto chips = link_.Last(topics::kDetectionChips);
  const auto boxes = link_.Last(topics::kDetections)->boxes;
  ASSERT_EQ(chips->chips.size(), boxes.size());
  EXPECT_EQ(chips->chips[0].box.color, boxes[0].color);
  EXPECT_NEAR(chips->chips[0].box.u, boxes[0].u, 0.1);
  frame = Picture({});
  frame.exposure += Seconds(60.0);
  link_.Send(app, topics::kCameraFrame, frame);
  EXPECT_EQ(link_.Count(topics::kDetectionChips), 3) << "nothing to be cut out";
}

TEST_F(Detect, TellsOnceASecondHowTheGroundStandsOut) {
  AppContext context;
  context.name = "pDetect";
  context.link = &link_;
  DetectApp app(context, {}, MakeDetector("color_shape"));
  CameraFrame frame = Picture({});
  for (int i = 0; i < 9; ++i) {
    link_.Send(app, topics::kCameraFrame, frame);
    frame.exposure += Seconds(0.25);
  }
  EXPECT_EQ(link_.Count(topics::kGroundContrast), 3);
  EXPECT_GT(link_.Last(topics::kGroundContrast)->green, 0.003);
}

}  // namespace
}  // namespace limpet
