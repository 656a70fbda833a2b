// SPDX-License-Identifier: MIT
// What an operator sees of the map.
#include <cstddef>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "apps/pMap/map_app.hpp"
#include "apps/pMap/map_warnings.hpp"
#include "limpet/survey/look.hpp"
#include "limpet/topics/survey_phase.hpp"

namespace limpet {
namespace {

/// How many frames were left out, by reason.
std::string LeftOut(const FrameGate& gate) {
  std::string text;
  for (std::size_t i = 0; i < kFrameDrops; ++i) {
    const auto drop = static_cast<FrameDrop>(i);
    if (gate.dropped(drop) == 0) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", gate.dropped(drop), NameOf(drop));
  }
  return text.empty() ? "none" : text;
}

}  // namespace

std::optional<double> MapApp::ChanceAtSeabed(const VisibilityBelief& water, double farther) const {
  if (!gate_.altitude()) {
    return std::nullopt;
  }
  return water.Expect(DetectionChances(params_.status.detection,
                                       {.range = farther * *gate_.altitude(), .share = 1.0},
                                       VisibilityBelief::Grid()));
}

void MapApp::WarnOfMurk(const VisibilityBelief& water) {
  // An estimate on the threshold wavers: over is what would not come back at a fifth more range.
  constexpr double kClearlyNearer = 1.2;
  const bool is_surveying = IsSurveying(phase_);
  const std::optional<double> chance = ChanceAtSeabed(water, is_murky_ ? kClearlyNearer : 1.0);
  is_murky_ = is_surveying && chance && *chance < kLookChance;
  if (is_murky_) {
    const WaterVisibility estimate = water.estimate();
    Warn(warnings::kWaterMurky,
         fmt::format("the seabed, {:.1f} m below, is most likely out of sight: visibility about "
                     "{:.1f} m, give or take {:.1f} m",
                     *gate_.altitude(), estimate.visibility.value(), estimate.sd.value()));
  } else {
    ClearWarning(warnings::kWaterMurky);
  }
}

void MapApp::WarnOfDoubtedLandmarks() {
  if (const int doubted = statuses_.landmarks_doubted(); doubted > 0) {
    Warn(warnings::kLandmarksDoubted,
         fmt::format("{} of pNav's objects, each seen at least ten times, the map takes for none: "
                     "most looks at them show no such box",
                     doubted));
  } else {
    ClearWarning(warnings::kLandmarksDoubted);
  }
}

void MapApp::WarnOfAllGone() {
  constexpr int kMany = 3;  // fewer may well be taken away together
  int gone = 0;
  bool is_one_found = false;
  for (const OpiBelief& object : objects_) {
    gone += object.decided == Status::kRemoved ? 1 : 0;
    is_one_found =
        is_one_found || object.decided == Status::kConfirmed || object.decided == Status::kMoved;
  }
  if (gone >= kMany && !is_one_found) {
    Warn(warnings::kFormerAllGone,
         fmt::format("{} objects of the former session are removed and none was found again: do "
                     "the sessions' frames lie apart?",
                     gone));
  } else {
    ClearWarning(warnings::kFormerAllGone);
  }
}

void MapApp::Report(ReportLines& report) const {
  report.Pair("Phase", phase_.empty() ? "none announced: every frame counts" : phase_);
  report.Pair("Frames used", std::to_string(gate_.used()));
  report.Pair("Left out", LeftOut(gate_));
  report.Pair("Landmarks doubted", std::to_string(statuses_.landmarks_doubted()));
  report.Pair("False boxes", fmt::format("{:.3f} per image", statuses_.false_per_image()));
  const VisibilityBelief belief = statuses_.Water();
  const WaterVisibility water = belief.estimate();
  report.Pair("Visibility", fmt::format("{:.1f} m, give or take {:.1f} m", water.visibility.value(),
                                        water.sd.value()));
  if (const std::optional<double> chance = ChanceAtSeabed(belief)) {
    report.Pair("Seabed", fmt::format("{:.0f} % of frames from here would show an object on it",
                                      100.0 * *chance));
  }
  report.Pair("DVL beams", fmt::format("{} used, {} left out as outliers", beams_ - beams_left_out_,
                                       beams_left_out_));
  report.Pair("Altitude", gate_.altitude()
                              ? fmt::format("{:.2f} m, {:.1f} s old", *gate_.altitude(),
                                            (now() - gate_.altitude_time()).value())
                              : "never heard");
  if (!ground_) {
    report.Pair("Coverage", "no SURVEY_AREA yet");
  } else {
    const Coverage seen = ground_->coverage();
    report.Pair("Coverage",
                fmt::format("seabed {:.1f} %, band {:.1f} %, its top {:.1f} %", 100.0 * seen.seabed,
                            100.0 * seen.band, 100.0 * seen.band_top));
  }
  report.Blank();
  if (objects_.empty()) {
    report.Add("No objects yet.");
    return;
  }
  ReportTable table({">id", "class", ">north", ">east", ">down", "status", ">there", ">looks",
                     ">boxes", ">former"});
  for (const OpiBelief& object : objects_) {
    const Eigen::Vector3d& ned = object.object.p_W;
    table.AddRow({std::to_string(object.id), object.object.color, fmt::format("{:.2f}", ned.x()),
                  fmt::format("{:.2f}", ned.y()), fmt::format("{:.2f}", ned.z()),
                  std::string(NameOf(object.decided)),
                  fmt::format("{:.3f}", object.posterior.present()), std::to_string(object.looks),
                  std::to_string(object.looks_with_box),
                  object.former_id ? std::to_string(*object.former_id) : "-"});
  }
  report.Add(table);
}

}  // namespace limpet
