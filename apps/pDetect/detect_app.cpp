// SPDX-License-Identifier: MIT
#include "apps/pDetect/detect_app.hpp"

#include <algorithm>

#include "limpet/app/registry.hpp"
#include "limpet/core/config.hpp"
#include "limpet/vision/color_shape_detector.hpp"
#include "limpet/vision/color_table.hpp"

namespace limpet {
namespace {

std::vector<std::string> ParseClasses(const std::string& text) {
  std::vector<std::string> classes;
  if (EqualsIgnoringCase(Trim(text), "all")) {
    return classes;
  }
  const std::vector<std::string> known = ColorNames();
  for (const std::string& part : Split(text, ',')) {
    const std::string name(Trim(part));
    if (std::ranges::find(known, name) == known.end()) {
      const std::string nearest = NearestWord(name, known);
      throw ConfigError(ConfigProblem{
          .where = {},
          .key = "classes",
          .text = "`" + name + "` is no class" +
                  (nearest.empty() ? std::string() : "; did you mean `" + nearest + "`?")});
    }
    classes.push_back(name);
  }
  return classes;
}

}  // namespace

DetectApp::DetectApp(const AppContext& context, const Params& params)
    : App(context),
      params_(params),
      classes_(ParseClasses(params.classes)),
      detector_(std::make_unique<ColorShapeDetector>()) {
  Subscribe(topics::kCameraFrame, &DetectApp::OnFrame);
}

bool DetectApp::IsWanted(const Box& box) const {
  return box.confidence >= params_.min_confidence &&
         (classes_.empty() || std::ranges::find(classes_, box.color) != classes_.end());
}

void DetectApp::OnFrame(const Stamped<CameraFrame>& frame) {
  const CameraFrame& image = frame.value;
  std::vector<Box> boxes = detector_->Detect({image.bgr.data(), image.width_px, image.height_px});
  std::erase_if(boxes, [this](const Box& box) { return !IsWanted(box); });
  Publish(topics::kDetections, Detections{.frame = static_cast<int>(image.frame),
                                          .exposure = image.exposure,
                                          .boxes = std::move(boxes)});
}

LIMPET_REGISTER_APP(DetectApp, "pDetect", 4.0);

}  // namespace limpet
