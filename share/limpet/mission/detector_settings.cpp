// SPDX-License-Identifier: MIT
#include "limpet/mission/detector_settings.hpp"

namespace limpet {
namespace {

std::vector<FactTaker> DetectorTakers() {
  std::vector<FactTaker> takers{{"pDetect", "detector", "detector.name"},
                                {"pNav", "wrong_color_share", "believed.wrong_color"},
                                {"pNav", "match_color_penalty", "believed.color_penalty"},
                                {"pMap", "detection_best", "believed.best"},
                                {"pMap", "detection_half_range", "believed.half_range_share"},
                                {"pMap", "detection_fall_off", "believed.fall_off_share"},
                                {"pMap", "detection_least_size_px", "believed.least_size_px"},
                                {"pMap", "detection_share_none", "believed.share_none"},
                                {"pMap", "detection_share_full", "believed.share_full"},
                                {"pMap", "false_detections_per_image", "believed.false_per_image"}};
  const auto box = [&takers](const char* key, const char* fact) {
    takers.push_back({"uSimCamera", key, fact});
  };
  box("box_peak", "boxes.peak");
  box("box_faint_at", "boxes.faint_at");
  box("box_faint_width", "boxes.faint_width");
  box("box_cut_at", "boxes.cut_at");
  box("box_cut_width", "boxes.cut_width");
  box("box_least_radius_px", "boxes.least_radius_px");
  box("box_centre_sd_px", "boxes.centre_sd_px");
  box("box_size_sd_px", "boxes.size_sd_px");
  box("box_size_bias_px", "boxes.size_bias_px");
  box("box_sd_growth_faint", "boxes.sd_growth_faint");
  box("box_sd_growth_cut", "boxes.sd_growth_cut");
  box("box_confidence", "boxes.confidence");
  box("box_confidence_loss_faint", "boxes.confidence_loss_faint");
  box("box_confidence_loss_cut", "boxes.confidence_loss_cut");
  box("box_confidence_sd", "boxes.confidence_sd");
  box("box_confusion_whole", "boxes.confusion_whole");
  box("box_confusion_cut", "boxes.confusion_cut");
  return takers;
}

}  // namespace

const FactFile& DetectorFacts() {
  static const FactFile kind{.global = kDetectorFileGlobal,
                             .folder = "detectors",
                             .of = "detector",
                             .takers = DetectorTakers()};
  return kind;
}

}  // namespace limpet
