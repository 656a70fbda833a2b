// SPDX-License-Identifier: MIT
#include "apps/uSimCamera/sim_camera_app.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "apps/uSimCamera/sim_camera_warnings.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/mission/fault_names.hpp"
#include "limpet/objects/lens_box.hpp"
#include "limpet/simulation/object_shape.hpp"

namespace limpet {
namespace {

bool Moves(const ObjectMotionParams& motion) {
  return !motion.sway_W.isZero(0.0) || !motion.drift_W.isZero(0.0);
}

Solid SolidOf(const ScenarioOpi& opi) {
  const ObjectShapeParams& form = opi.shape;
  Solid solid{.kind = SolidKindOf(form.shape).value_or(SolidKind::kSphere),
              .radius = opi.radius_m,
              .height = form.shape == "sphere" ? 2.0 * opi.radius_m : form.height.value(),
              .color = opi.color,
              .band_color = form.band == "none" ? "" : form.band};
  // The top leans towards the heading.
  solid.R_WS = RotationFromRollPitchYaw(0.0, -form.tilt.value(), form.heading.value());
  return solid;
}

}  // namespace

SimCameraApp::SimCameraApp(const AppContext& context, const Params& params)
    : App(context),
      params_(params),
      lens_(params.geometry.lens()),
      stamp_({}, Random(0)),
      seabed_({}),
      contrast_random_(MakeRandom("ground contrast")),
      box_model_(BoxModel::Settings{}),
      box_random_(MakeRandom("boxes")),
      storm_random_(MakeRandom("false boxes")) {
  const Scenario scenario = LoadScenario(context.mission_folder / params.scenario);
  for (const ScenarioOpi& opi : scenario.opis) {
    if (const auto place = opi.Place(context.session)) {
      spheres_.push_back({.p_W = *place, .radius = opi.radius_m, .color = opi.color});
      solids_.push_back(SolidOf(opi));
      motions_.push_back(opi.motion);
    }
  }
  bodies_ = BodiesOf(scenario);
  seabed_ = Seabed(scenario.seabed);
  errors_ = scenario.errors.camera;
  faults_ = FaultSchedule(scenario.faults);
  for (const std::string& variable : faults_.Variables()) {
    SubscribeRaw(variable, [this](const MessagePtr& message) {
      faults_.Hear(message->name, message->value);
    });
  }
  stamp_ = StampError(errors_.stamps, MakeRandom("stamps camera"));
  camera_ = errors_.mounting.Applied(lens_.enclosing());
  MakeCamera(context, scenario);
  Subscribe(topics::kSimTruth, &SimCameraApp::OnTruth);
}

void SimCameraApp::MakeCamera(const AppContext& context, const Scenario& scenario) {
  const std::string kind = params_.camera == "scenario" ? scenario.camera : params_.camera;
  if (kind != "rendered") {
    Random site(MixSeed(context.seed, "seabed texture"));  // the same ground in every session
    contrast_model_.emplace(scenario.water.visibility_m, site);
    box_model_ = BoxModel({.camera = camera_,
                           .visibility_m = scenario.water.visibility_m,
                           .false_boxes_per_image = scenario.sensors.false_detections_per_image,
                           .constants = params_.boxes});
    return;
  }
  if (faults_.Has(fault_names::kFalseBoxes)) {
    Warn(warnings::kNoFalseBoxes,
         "the scenario's fault `false_boxes` is not made: this camera renders pictures; "
         "camera = boxes makes it");
  }
  const auto depth = [seabed = seabed_](const Eigen::Vector2d& p_W) { return seabed.Depth(p_W); };
  // The place looks the same in every session; noise and specks do not.
  const std::uint64_t seabed_seed = MixSeed(context.seed, "seabed texture");
  const std::uint64_t noise_seed = MakeRandom("image noise").Bits();
  const SceneSettings scene{.camera = camera_,
                            .seabed_depth = depth,
                            .visibility_m = scenario.water.visibility_m,
                            .seabed_seed = seabed_seed,
                            .noise_seed = noise_seed};
  if (scenario.image.look == "plain") {
    renderer_.emplace(scene);
  } else {
    pictures_.emplace(
        PictureSettings{.scene = scene,
                        .image = scenario.image,
                        .decoys_per_image = scenario.sensors.false_detections_per_image});
  }
  if (!lens_.is_pinhole()) lens_image_.emplace(lens_);
}

Image SimCameraApp::Picture(const Stamped<SimTruth>& truth, std::span<const Sphere> shown) {
  if (renderer_) return renderer_->Render(truth.value.pose(), InSight(truth.value, shown), frame_);
  std::vector<Solid> solids;
  for (std::size_t i = 0; i < solids_.size(); ++i) {
    if (IsHidden(truth.value, shown[i])) continue;
    solids.push_back(solids_[i]);
    solids.back().p_W = shown[i].p_W;
  }
  return pictures_->Render(truth.value.pose(), solids, frame_, truth.time - *start_);
}

bool SimCameraApp::IsHidden(const SimTruth& truth, const Sphere& sphere) const {
  const Pose X_WB = truth.pose();
  const Eigen::Vector3d eye_W = X_WB.p_WB + RotationOf(X_WB) * camera_.p_BC;
  return std::ranges::any_of(
      bodies_, [&](const UprightBody& body) { return body.IsBetween(eye_W, sphere.p_W); });
}

std::vector<Sphere> SimCameraApp::InSight(const SimTruth& truth,
                                          std::span<const Sphere> shown) const {
  std::vector<Sphere> in_sight(shown.begin(), shown.end());
  if (bodies_.empty()) return in_sight;
  std::erase_if(in_sight, [&](const Sphere& sphere) { return IsHidden(truth, sphere); });
  return in_sight;
}

void SimCameraApp::OnTruth(const Stamped<SimTruth>& truth) {
  // The millionth absorbs what a time that is no exact multiple loses in the product.
  const double slot = std::floor(truth.time.value() * params_.timing.rate.value() + 1e-6);
  if (!start_) start_ = truth.time;
  faults_.Update(truth.time);
  const bool makes_frames = truth.value.down >= params_.least_depth.value() &&
                            faults_.Active(fault_names::kCameraSilent) == nullptr;
  if (slot != last_slot_ && makes_frames) {
    last_slot_ = slot;
    const std::vector<Sphere> shown = Shown(truth);
    const Seconds stamp = stamp_.StampOf(truth.time);
    // A driver stamps what it hands on: no frame comes before its stamp.
    const Seconds taken = std::max(truth.time, stamp);
    if (renderer_ || pictures_) {
      exposed_.emplace_back(taken, MakeImage(truth, shown, stamp));
    } else {
      exposed_.emplace_back(taken, MakeBoxes(truth.value, shown, stamp));
      PublishContrast(truth.value, stamp);
    }
    ++frame_;
  }
  PublishReady(truth.time);
}

std::vector<Sphere> SimCameraApp::Shown(const Stamped<SimTruth>& truth) {
  std::vector<Sphere> shown = spheres_;
  const SimTruth& body = truth.value;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (Moves(motions_[i])) shown[i].p_W += motions_[i].At(truth.time - *start_);
    shown[i].p_W = SeenRowByRow(
        errors_.shutter, camera_, body.pose(),
        {.v_B = {body.u, body.v, body.w}, .omega_B = {body.p, body.q, body.r}}, shown[i].p_W);
  }
  return shown;
}

CameraFrame SimCameraApp::MakeImage(const Stamped<SimTruth>& truth, std::span<const Sphere> shown,
                                    Seconds stamp) {
  Image image = Picture(truth, shown);
  if (lens_image_) image = lens_image_->Distorted(image);
  return {.frame = frame_,
          .exposure = stamp,
          .width_px = image.width_px,
          .height_px = image.height_px,
          .bgr = std::move(image.bgr)};
}

Detections SimCameraApp::MakeBoxes(const SimTruth& truth, std::span<const Sphere> shown,
                                   Seconds stamp) {
  Detections seen{.frame = static_cast<int>(frame_), .exposure = stamp, .boxes = {}};
  for (const Box& box : box_model_.Detect(truth.pose(), InSight(truth, shown), box_random_)) {
    if (const auto distorted = Distorted(lens_, box)) seen.boxes.push_back(*distorted);
  }
  AddFalseBoxes(seen.boxes);
  return seen;
}

void SimCameraApp::AddFalseBoxes(std::vector<Box>& boxes) {
  const ScenarioFault* storm = faults_.Active(fault_names::kFalseBoxes);
  if (storm == nullptr) return;
  for (int i = 0; i < static_cast<int>(storm->size); ++i) {
    boxes.push_back(box_model_.DrawFalse(storm_random_));
  }
  std::ranges::stable_sort(boxes, std::ranges::greater(), &Box::confidence);
}

void SimCameraApp::PublishContrast(const SimTruth& truth, Seconds stamp) {
  const double range = seabed_.Depth({truth.north, truth.east}) - truth.down;
  if (range <= 0.0 || (last_contrast_ && stamp - *last_contrast_ < kContrastPeriod)) {
    return;
  }
  last_contrast_ = stamp;
  GroundContrast contrast = contrast_model_->Draw(range, contrast_random_);
  contrast.exposure = stamp.value();
  Publish(topics::kGroundContrast, contrast);
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
  report.Pair("Makes", renderer_   ? "images"
                       : pictures_ ? "images with the real look"
                                   : "boxes, without images");
  report.Pair("Frames", fmt::format("{} at {:g} Hz", frame_, params_.timing.rate.value()));
  report.Pair("Objects", fmt::format("{} in this session", spheres_.size()));
}

LIMPET_REGISTER_APP(SimCameraApp, "uSimCamera", 4.0);

}  // namespace limpet
