// SPDX-License-Identifier: MIT
#include "limpet/characterisation/detector_trial.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "limpet/core/random.hpp"
#include "limpet/imaging/picture_renderer.hpp"
#include "limpet/objects/pixel_rect.hpp"

namespace limpet {
namespace {

constexpr double kDepth = 8.0;

PictureSettings DrawWorld(const TrialPlan& plan, Random& random) {
  PictureSettings settings{.scene = {.camera = {}, .seabed_depth = {}}, .image = {}};
  const double wave = random.Uniform(0.0, 0.1);
  settings.scene.seabed_depth = [wave](const Eigen::Vector2d& p_W) {
    return kDepth + wave * std::sin(1.3 * p_W.x()) * std::cos(0.8 * p_W.y());
  };
  settings.scene.visibility_m = random.Uniform(plan.least_visibility_m, plan.most_visibility_m);
  settings.scene.seabed_seed = random.Bits();
  settings.scene.noise_seed = random.Bits();
  ImageParams& image = settings.image;
  image.look = "real";
  image.seabed.kind = kSeabedKinds.at(random.Index(kSeabedKinds.size()));
  image.water.dissolved = random.Uniform(0.1, 1.2);
  image.water.backscatter = random.Uniform(0.5, 1.5);
  // From a bare bottom to one where every square metre has its stone.
  image.clutter = {.natural_per_m2 = 0.01 * std::pow(100.0, random.Uniform(0.0, 1.0)),
                   .litter_per_m2 = 0.0};
  image.light.caustics = random.Uniform(0.0, 0.8);
  if (random.Chance(0.2)) {
    image.light.sun = 0.0;
    image.light.lamp = 1.0;
  }
  image.sensor.exposure = random.Uniform(-0.7, 0.7);
  return settings;
}

/// A body 1.2 to 6 m above the bottom, rolling and pitching a little.
Pose DrawPose(Random& random) {
  Pose pose;
  pose.p_WB = {random.Uniform(-30.0, 30.0), random.Uniform(-30.0, 30.0),
               kDepth - random.Uniform(1.2, 6.0)};
  pose.roll = random.Normal(0.04);
  pose.pitch = random.Normal(0.04);
  pose.yaw = random.Uniform(-std::numbers::pi, std::numbers::pi);
  return pose;
}

Eigen::Vector3d DrawPlace(const Pose& pose, double above, Random& random) {
  const double reach = std::max(0.5, kDepth - above - pose.p_WB.z());
  return {pose.p_WB.x() + reach * random.Uniform(-0.8, 0.8),
          pose.p_WB.y() + reach * random.Uniform(-0.8, 0.8), kDepth - above};
}

Solid DrawBall(const TrialPlan& plan, const Pose& pose, Random& random) {
  Solid ball;
  ball.radius = 0.03 * std::pow(20.0, random.Uniform(0.0, 1.0));
  const double highest = std::min(2.0, kDepth - pose.p_WB.z() - 0.7 - ball.radius);
  const bool floats = random.Chance(0.5) && highest > ball.radius;
  const double above = floats ? random.Uniform(ball.radius, highest) : ball.radius;
  ball.p_W = DrawPlace(pose, above, random);
  ball.color = plan.colors.at(random.Index(plan.colors.size()));
  return ball;
}

Solid DrawOther(const TrialPlan& plan, const Pose& pose, Random& random) {
  constexpr std::array kKinds{SolidKind::kCylinder, SolidKind::kCone, SolidKind::kBox,
                              SolidKind::kTyre};
  Solid solid = DrawBall(plan, pose, random);
  solid.kind = kKinds.at(random.Index(kKinds.size()));
  solid.height = solid.radius * random.Uniform(0.8, 3.0);
  if (solid.kind == SolidKind::kTyre) solid.height = 0.6 * solid.radius;
  // In this order: arguments of one call are evaluated in any.
  const double east = random.Normal(1.0), north = random.Normal(1.0);
  const double angle = random.Uniform(0.0, std::numbers::pi);
  const Eigen::Vector3d axis = Eigen::Vector3d(north, east, 0.01).normalized();
  solid.R_WS = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  solid.p_W.z() = kDepth - 0.6 * solid.radius;
  return solid;
}

TrialLook LookAt(const Pose& pose, double visibility, const Solid& solid, const SolidLabel& label) {
  return {.kind = solid.kind,
          .color = solid.color,
          .range = (solid.p_W - pose.p_WB).norm(),
          .visibility_m = visibility,
          .size_px = std::sqrt(label.outline.area()),
          .visible_fraction =
              label.visible_fraction * std::min(1.0, label.visible.area() / label.outline.area()),
          .visible = label.visible,
          .found = {}};
}

/// Which boxes are whose.
void Compare(const std::vector<TrialLook>& looks, const std::vector<Box>& boxes,
             TrialResult& result) {
  std::vector<bool> is_explained(boxes.size(), false);
  for (TrialLook look : looks) {
    for (std::size_t b = 0; b < boxes.size(); ++b) {
      const PixelRect rect = RectOf(boxes[b]);
      if (!look.found && Overlap(rect, look.visible) > 0.5) look.found = boxes[b];
      if (Intersection(rect, look.visible).area() > 0.5 * rect.area()) is_explained[b] = true;
    }
    result.looks.push_back(std::move(look));
  }
  result.false_boxes += static_cast<int>(std::ranges::count(is_explained, false));
}

}  // namespace

void MakeTrialPictures(const TrialPlan& plan, const std::function<void(const TrialPicture&)>& take,
                       const std::function<void(int)>& progress) {
  Random random(plan.seed, "detector trial");
  for (int world = 0; world < plan.worlds; ++world) {
    const PictureSettings settings = DrawWorld(plan, random);
    PictureRenderer renderer(settings);
    for (int i = 0; i < plan.pictures_per_world; ++i) {
      const Pose pose = DrawPose(random);
      std::vector<Solid> solids;
      for (std::uint64_t n = random.Index(4); n > 0; --n)
        solids.push_back(DrawBall(plan, pose, random));
      if (random.Chance(0.25)) solids.push_back(DrawOther(plan, pose, random));
      TrialPicture picture{
          .image = renderer.Render(pose, solids, static_cast<std::uint32_t>(i), Seconds(0.3 * i)),
          .looks = {}};
      for (const SolidLabel& label : renderer.labels()) {
        picture.looks.push_back(
            LookAt(pose, settings.scene.visibility_m, solids[label.solid], label));
      }
      take(picture);
    }
    if (progress) progress(world + 1);
  }
}

TrialResult RunTrial(const TrialPlan& plan, Detector& detector,
                     const std::function<void(int)>& progress) {
  TrialResult result;
  MakeTrialPictures(
      plan,
      [&](const TrialPicture& picture) {
        ++result.pictures;
        Compare(picture.looks, detector.Detect(picture.image.view()), result);
      },
      progress);
  return result;
}

}  // namespace limpet
