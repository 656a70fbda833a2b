// SPDX-License-Identifier: MIT
#include "training/detector/rendered_frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "limpet/core/random.hpp"
#include "limpet/imaging/picture_renderer.hpp"
#include "limpet/objects/color_table.hpp"

namespace limpet {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

double LogUniform(double low, double high, Random& random) {
  return low * std::pow(high / low, random.Uniform(0.0, 1.0));
}

std::string AnyColor(Random& random) {
  const std::vector<std::string> names = ColorNames();
  return names[random.Index(names.size())];
}

void DrawLight(ImageParams::Light& light, Random& random) {
  light.sun = random.Chance(0.12) ? 0.0 : random.Uniform(0.3, 1.5);
  light.elevation = Radians(random.Uniform(45.0, 88.0) * kDegree);
  light.azimuth = Radians(random.Uniform(0.0, 360.0) * kDegree);
  light.caustics = random.Uniform(0.0, 1.0);
  light.lamp = light.sun == 0.0 || random.Chance(0.25) ? LogUniform(0.2, 5.0, random) : 0.0;
  light.lamp_off = random.Uniform(0.1, 0.6);
  light.lamp_beam = Radians(random.Uniform(25.0, 70.0) * kDegree);
}

void DrawSensor(ImageParams::Sensor& sensor, Random& random) {
  sensor.exposure = random.Uniform(-1.2, 1.0);
  sensor.white_balance = random.Uniform(0.0, 1.0);
  sensor.full_well = LogUniform(1500.0, 20000.0, random);
  sensor.read_noise = random.Uniform(2.0, 30.0);
  sensor.contrast = random.Uniform(0.0, 0.8);
  sensor.saturation = random.Uniform(0.6, 1.6);
  sensor.jpeg_quality = random.Chance(0.4) ? 0.0 : random.Uniform(15.0, 95.0);
}

PictureSettings DrawSettings(std::uint64_t seed, double depth, Random& random) {
  PictureSettings settings{.scene = {.camera = {}, .seabed_depth = {}}, .image = {}};
  const double wave = random.Uniform(0.0, 0.15);
  settings.scene.seabed_depth = [depth, wave](const Eigen::Vector2d& p_W) {
    return depth + wave * std::sin(1.3 * p_W.x()) * std::cos(0.8 * p_W.y());
  };
  settings.scene.visibility_m = LogUniform(2.5, 20.0, random);
  settings.scene.seabed_seed = seed;
  settings.scene.noise_seed = seed + 1;
  ImageParams& image = settings.image;
  image.look = "real";
  image.seabed = {.kind = kSeabedKinds.at(random.Index(kSeabedKinds.size())),
                  .shading = random.Uniform(0.5, 2.0)};
  image.water = {.dissolved = LogUniform(0.03, 2.5, random),
                 .backscatter = random.Uniform(0.3, 2.5),
                 .forward_scatter = random.Uniform(0.0, 0.6),
                 .particles = random.Uniform(0.0, 200.0)};
  // Its litter holds balls, too, which nobody would label.
  image.clutter = {.natural_per_m2 = LogUniform(0.1, 6.0, random), .litter_per_m2 = 0.0};
  image.lens = {.blur = random.Uniform(0.3, 1.8), .vignette = random.Uniform(0.0, 0.6)};
  DrawLight(image.light, random);
  DrawSensor(image.sensor, random);
  return settings;
}

/// Somewhere in view, up to `rise` above the seabed.
Eigen::Vector3d PlaceNear(const Pose& pose, double depth, double rise, Random& random) {
  const double range = std::max(0.5, depth - rise - pose.p_WB.z());
  const double reach = 0.95 * range;
  return {pose.p_WB.x() + random.Uniform(-reach, reach),
          pose.p_WB.y() + random.Uniform(-reach, reach), depth - rise};
}

Solid DrawSphere(const Pose& pose, double depth, Random& random) {
  Solid ball;
  ball.radius = LogUniform(0.05, 0.6, random);
  const double most = std::max(ball.radius, 0.7 * (depth - pose.p_WB.z()));
  const double rise = random.Chance(0.5) ? ball.radius : random.Uniform(ball.radius, most);
  ball.p_W = PlaceNear(pose, depth, rise, random);
  ball.color = AnyColor(random);
  return ball;
}

Solid DrawOther(const Pose& pose, double depth, Random& random) {
  constexpr std::array kKinds{SolidKind::kCylinder, SolidKind::kCone, SolidKind::kBox,
                              SolidKind::kTyre};
  Solid solid;
  solid.kind = kKinds.at(random.Index(kKinds.size()));
  solid.radius = LogUniform(0.06, 0.5, random);
  solid.height = solid.radius * random.Uniform(0.4, 4.0);
  if (solid.kind == SolidKind::kTyre) solid.height = 0.6 * solid.radius;
  solid.top_share = random.Uniform(0.1, 0.8);
  const double east = random.Normal(1.0), north = random.Normal(1.0);
  const Eigen::AngleAxisd lean(random.Uniform(0.0, std::numbers::pi),
                               Eigen::Vector3d(north, east, 0.01).normalized());
  solid.R_WS = lean.toRotationMatrix();
  solid.p_W = PlaceNear(pose, depth, random.Uniform(0.3, 1.0) * solid.radius, random);
  solid.color = AnyColor(random);
  solid.band_color = random.Chance(0.3) ? AnyColor(random) : "";
  return solid;
}

Pose DrawPose(double depth, Random& random) {
  Pose pose;
  pose.p_WB = {random.Uniform(-40.0, 40.0), random.Uniform(-40.0, 40.0),
               depth - LogUniform(0.8, 6.0, random)};
  pose.yaw = random.Uniform(0.0, 6.28);
  pose.roll = random.Normal(0.08);
  pose.pitch = random.Normal(0.08);
  return pose;
}

BallLabel SphereLabel(const SolidLabel& label, const Solid& ball) {
  const PixelRect& seen = label.visible;
  BallLabel made;
  made.box = {.u = seen.center_u(),
              .v = seen.center_v(),
              .w = seen.width(),
              .h = seen.height(),
              .confidence = 1.0,
              .color = ball.color};
  const double shown = seen.area() / std::max(label.outline.area(), 1.0);
  made.is_hidden = label.visible_fraction < 0.5 || shown < 0.3;
  return made;
}

}  // namespace

std::vector<LabelledPicture> RenderedFrames(std::uint64_t seed, int frames) {
  Random random(seed, "rendered frames");
  const double depth = LogUniform(3.0, 12.0, random);
  PictureRenderer renderer(DrawSettings(seed, depth, random));
  std::vector<LabelledPicture> pictures;
  for (int frame = 0; frame < frames; ++frame) {
    const Pose pose = DrawPose(depth, random);
    const auto balls = static_cast<std::size_t>(random.Index(4));
    std::vector<Solid> solids;
    for (std::size_t i = 0; i < balls; ++i)
      solids.push_back(DrawSphere(pose, depth, random));
    for (std::uint64_t i = random.Index(4); i > 0; --i)
      solids.push_back(DrawOther(pose, depth, random));
    Image image = renderer.Render(pose, solids, static_cast<unsigned>(frame),
                                  Seconds(random.Uniform(0.0, 100.0)));
    LabelledPicture picture;
    for (const SolidLabel& label : renderer.labels()) {
      if (label.solid < balls) picture.labels.push_back(SphereLabel(label, solids[label.solid]));
    }
    picture.pixels =
        cv::Mat3b(image.height_px, image.width_px, reinterpret_cast<cv::Vec3b*>(image.bgr.data()))
            .clone();
    MarkUnclear(picture);
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

}  // namespace limpet
