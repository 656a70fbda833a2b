// SPDX-License-Identifier: MIT
#include "apps/uSimCamera/sim_camera_app.hpp"

#include <cmath>

#include <fmt/format.h>

#include "limpet/app/registry.hpp"
#include "limpet/mission/seabed.hpp"

namespace limpet {
namespace {

std::vector<Sphere> SpheresOf(const Scenario& scenario, const std::string& session) {
  std::vector<Sphere> spheres;
  for (const ScenarioOpi& opi : scenario.opis) {
    if (const auto place = opi.Place(session)) {
      spheres.push_back({.p_W = *place, .radius = opi.radius_m, .color = opi.color});
    }
  }
  return spheres;
}

}  // namespace

SimCameraApp::SimCameraApp(const AppContext& context, const Params& params)
    : App(context),
      params_(params),
      box_model_(BoxModel::Settings{}),
      box_random_(MakeRandom("boxes")) {
  const Scenario scenario = LoadScenario(context.mission_folder / params.scenario);
  spheres_ = SpheresOf(scenario, context.session);
  const CameraModel camera = params.geometry.geometry();
  const std::string kind = params.camera == "scenario" ? scenario.camera : params.camera;
  if (kind == "rendered") {
    renderer_.emplace(SceneSettings{
        .camera = camera,
        .seabed_depth = [seabed = Seabed(scenario.seabed)](
                            double north, double east) { return seabed.Depth(north, east); },
        .visibility_m = scenario.water.visibility_m,
        // The place looks the same in every session; noise and specks do not.
        .seabed_seed = MixSeed(context.seed, "seabed texture"),
        .noise_seed = MakeRandom("image noise").Bits()});
  } else {
    box_model_ = BoxModel({.camera = camera,
                           .visibility_m = scenario.water.visibility_m,
                           .false_boxes_per_image = scenario.sensors.false_detections_per_image,
                           .constants = {}});
  }
  Subscribe(topics::kSimTruth, &SimCameraApp::OnTruth);
}

void SimCameraApp::OnTruth(const Stamped<SimTruth>& truth) {
  // The millionth absorbs what a time that is no exact multiple loses in the product.
  const double slot = std::floor(truth.time.value() * params_.timing.rate.value() + 1e-6);
  if (slot != last_slot_ && truth.value.down >= params_.least_depth.value()) {
    last_slot_ = slot;
    if (renderer_) {
      exposed_.emplace_back(truth.time, MakeImage(truth));
    } else {
      exposed_.emplace_back(truth.time, MakeBoxes(truth));
    }
    ++frame_;
  }
  PublishReady(truth.time);
}

CameraFrame SimCameraApp::MakeImage(const Stamped<SimTruth>& truth) {
  Image image = renderer_->Render(truth.value.pose(), spheres_, frame_);
  return {.frame = frame_,
          .exposure = truth.time,
          .width_px = image.width_px,
          .height_px = image.height_px,
          .bgr = std::move(image.bgr)};
}

Detections SimCameraApp::MakeBoxes(const Stamped<SimTruth>& truth) {
  return {.frame = static_cast<int>(frame_),
          .exposure = truth.time,
          .boxes = box_model_.Detect(truth.value.pose(), spheres_, box_random_)};
}

void SimCameraApp::PublishReady(Seconds now) {
  constexpr Seconds kSlack(1e-6);  // MOOS time is coarse
  while (!exposed_.empty() && now + kSlack >= exposed_.front().first + params_.timing.latency) {
    const auto& made = exposed_.front().second;
    if (const auto* image = std::get_if<CameraFrame>(&made)) {
      Publish(topics::kCameraFrame, *image);
    } else {
      Publish(topics::kDetections, std::get<Detections>(made));
    }
    exposed_.pop_front();
  }
}

void SimCameraApp::Report(ReportLines& report) const {
  report.Pair("Makes", renderer_ ? "images" : "boxes, without images");
  report.Pair("Frames", fmt::format("{} at {:g} Hz", frame_, params_.timing.rate.value()));
  report.Pair("Objects", fmt::format("{} in this session", spheres_.size()));
}

LIMPET_REGISTER_APP(SimCameraApp, "uSimCamera", 4.0);

}  // namespace limpet
