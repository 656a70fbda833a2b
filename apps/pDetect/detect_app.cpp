// SPDX-License-Identifier: MIT
#include "apps/pDetect/detect_app.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "apps/pDetect/detect_block.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/core/config.hpp"
#include "limpet/objects/color_table.hpp"
#include "limpet/topics/chips.hpp"
#include "limpet/vision/chip_cutter.hpp"
#include "limpet/vision/ground_contrast.hpp"

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

DetectApp::DetectApp(const AppContext& context, const Params& params,
                     std::unique_ptr<Detector> detector)
    : App(context),
      params_(params),
      classes_(ParseClasses(params.classes)),
      detector_(std::move(detector)) {
  Subscribe(topics::kCameraFrame, &DetectApp::OnFrame);
}

bool DetectApp::IsWanted(const Box& box) const {
  return box.confidence >= params_.min_confidence &&
         (classes_.empty() || std::ranges::find(classes_, box.color) != classes_.end());
}

void DetectApp::PublishContrast(ImageView picture, Seconds exposure) {
  if (last_contrast_ && exposure - *last_contrast_ < kContrastPeriod) {
    return;
  }
  last_contrast_ = exposure;
  GroundContrast contrast = MeasureGroundContrast(picture);
  contrast.exposure = exposure.value();
  Publish(topics::kGroundContrast, contrast);
}

void DetectApp::OnFrame(const Stamped<CameraFrame>& frame) {
  const CameraFrame& image = frame.value;
  const ImageView picture{image.bgr.data(), image.width_px, image.height_px};
  PublishContrast(picture, image.exposure);
  std::vector<Box> boxes = detector_->Detect(picture);
  std::erase_if(boxes, [this](const Box& box) { return !IsWanted(box); });
  ++frames_;
  frames_with_boxes_ += boxes.empty() ? 0 : 1;
  last_ = {.frame = static_cast<int>(image.frame),
           .exposure = image.exposure,
           .boxes = std::move(boxes)};
  PublishChips(picture);  // before the boxes: who hears of these has the pictures
  Publish(topics::kDetections, last_);
}

void DetectApp::PublishChips(ImageView picture) {
  if (last_chips_ && last_.exposure - *last_chips_ < params_.chips_every) return;
  ImageChips chips{.exposure = last_.exposure, .chips = {}};
  for (const Box& box : last_.boxes) {
    if (box.confidence >= params_.chip_confidence) {
      chips.chips.push_back(CutChip(picture, box, {}));
    }
  }
  if (chips.chips.empty()) return;
  last_chips_ = last_.exposure;
  Publish(topics::kDetectionChips, chips);
}

void DetectApp::Report(ReportLines& report) const {
  report.Pair("Detector", params_.detector + ", classes " + params_.classes);
  report.Pair("Frames", fmt::format("{}, {} of them with boxes", frames_, frames_with_boxes_));
  if (frames_ == 0) {
    return;
  }
  report.Pair("Last frame", fmt::format("{}, {:.1f} s ago, {} boxes", last_.frame,
                                        (now() - last_.exposure).value(), last_.boxes.size()));
  ReportTable table({"class", ">sure", ">u [px]", ">v [px]", ">width", ">height"});
  for (const Box& box : last_.boxes) {
    table.AddRow({box.color, fmt::format("{:.2f}", box.confidence), fmt::format("{:.0f}", box.u),
                  fmt::format("{:.0f}", box.v), fmt::format("{:.0f}", box.w),
                  fmt::format("{:.0f}", box.h)});
  }
  if (!table.empty()) {
    report.Add(table);
  }
}

namespace {

/// Registers as LIMPET_REGISTER_APP does, with the keys of the detector that a block names.
const bool is_registered = [] {
  AppRegistry()["pDetect"] = {.default_tick_hz = 4.0,
                              .describe =
                                  [] {
                                    DetectApp::Params defaults;
                                    return DescribeParams(defaults);
                                  },
                              .create = CreateDetectApp,
                              .check = CheckDetectBlock};
  return true;
}();

}  // namespace
}  // namespace limpet
