// SPDX-License-Identifier: MIT
#include "limpet/imaging/picture_renderer.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/random.hpp"
#include "limpet/core/require.hpp"
#include "limpet/imaging/scene_light.hpp"
#include "limpet/imaging/seabed_kinds.hpp"
#include "limpet/imaging/solid_image.hpp"
#include "limpet/imaging/solid_painter.hpp"

namespace limpet {
namespace {

/// East, north, up from NED.
Eigen::Vector3d EastNorthUp(const Eigen::Vector3d& ned) { return {ned.y(), ned.x(), -ned.z()}; }

Clutter::Density DensityOf(const PictureSettings& settings) {
  const CameraModel& camera = settings.scene.camera;
  const double across = 2.0 * camera.half_across() * PictureRenderer::kDecoyRange;
  const double along = 2.0 * camera.half_along() * PictureRenderer::kDecoyRange;
  const ImageParams::Clutter& clutter = settings.image.clutter;
  return {.natural_per_m2 = clutter.natural_per_m2,
          .litter_per_m2 = clutter.litter_per_m2 + settings.decoys_per_image / (across * along)};
}

struct Painted {
  SolidPainter painter;
  std::size_t solid;  ///< index among the objects; beyond them: litter
  int pixels = 0;     ///< of it, before nearer ones hid some
};

}  // namespace

PictureRenderer::PictureRenderer(const PictureSettings& settings)
    : settings_(settings),
      water_(Meters(settings.scene.visibility_m), settings.image.water),
      lamp_(settings.image.light, water_),
      caustics_(settings.image.light.caustics, settings.scene.noise_seed),
      relief_(settings.scene.seabed_depth),
      towards_sun_W_(TowardsSun(settings.image.light)),
      ground_(settings.scene.camera,
              MakeSeabed(settings.image.seabed.kind, settings.scene.seabed_seed)
                  .Lit(EastNorthUp(towards_sun_W_), settings.image.seabed.shading),
              settings.scene.seabed_seed),
      clutter_(DensityOf(settings), settings.scene.seabed_seed),
      lens_(settings.image.lens),
      sensor_(settings.image.sensor, settings.scene.camera.width_px, settings.scene.noise_seed),
      jpeg_(static_cast<int>(settings.image.sensor.jpeg_quality)),
      linear_(settings.scene.camera.width_px, settings.scene.camera.height_px, ground_.stride()),
      label_image_(static_cast<std::size_t>(settings.scene.camera.width_px) *
                   static_cast<std::size_t>(settings.scene.camera.height_px)) {
  LIMPET_REQUIRE(settings.scene.seabed_depth != nullptr, "a picture needs a seabed");
}

void PictureRenderer::AddLabel(SolidLabel found, std::uint8_t label, int painted_pixels) {
  const PixelRect& outline = found.outline;
  const int width = settings_.scene.camera.width_px;
  const int height = settings_.scene.camera.height_px;
  const int top = std::clamp(static_cast<int>(outline.top) - 1, 0, height);
  const int bottom = std::clamp(static_cast<int>(outline.bottom) + 2, 0, height);
  const int first = std::clamp(static_cast<int>(outline.left) - 1, 0, width);
  const int last = std::clamp(static_cast<int>(outline.right) + 2, 0, width);
  found.visible = {static_cast<double>(width), static_cast<double>(height), 0.0, 0.0};
  int pixels = 0;
  for (int row = top; row < bottom; ++row) {
    for (int column = first; column < last; ++column) {
      if (label_image_[static_cast<std::size_t>(row * width + column)] != label) continue;
      ++pixels;
      found.visible.left = std::min(found.visible.left, static_cast<double>(column));
      found.visible.right = std::max(found.visible.right, column + 1.0);
      found.visible.top = std::min(found.visible.top, static_cast<double>(row));
      found.visible.bottom = std::max(found.visible.bottom, row + 1.0);
    }
  }
  if (pixels == 0) return;
  found.visible_fraction = static_cast<double>(pixels) / painted_pixels;
  labels_.push_back(found);
}

void PictureRenderer::PaintSolids(const Pose& X_WB, std::span<const Solid> solids,
                                  const SceneLight& light) {
  std::vector<Painted> painted;
  const auto add = [&](const Solid& solid, std::size_t index) {
    if (auto painter = SolidPainter::Make(settings_.scene.camera, X_WB, solid, light)) {
      painted.push_back({*painter, index});
    }
  };
  for (std::size_t i = 0; i < solids.size(); ++i)
    add(solids[i], i);
  for (const Solid& lost : litter_)
    add(lost, solids.size());
  std::ranges::stable_sort(painted, std::ranges::greater(),
                           [](const Painted& one) { return one.painter.range(); });
  std::ranges::fill(label_image_, std::uint8_t{0});
  constexpr std::size_t kMostLabels = 254;
  for (std::size_t i = 0; i < painted.size(); ++i) {
    const auto label = static_cast<std::uint8_t>(std::min(i, kMostLabels) + 1);
    painted[i].pixels = painted[i].painter.Paint(linear_, label_image_.data(), label);
  }
  for (std::size_t i = 0; i < std::min(painted.size(), kMostLabels); ++i) {
    if (painted[i].solid < solids.size()) {
      AddLabel({.solid = painted[i].solid, .outline = painted[i].painter.outline()},
               static_cast<std::uint8_t>(i + 1), painted[i].pixels);
    }
  }
}

/// Drifting flakes near the lens: the nearer, the larger, brighter and less sharp.
void PictureRenderer::AddFlakes(const SceneLight& light, std::uint32_t frame) {
  const double mean = settings_.image.water.particles;
  if (mean <= 0.0) return;
  Random random(settings_.scene.noise_seed + frame, "flakes");
  const int count = static_cast<int>(mean + std::sqrt(mean) * random.Normal(1.0));
  for (int i = 0; i < count; ++i) {
    const double u = random.Uniform(0.0, settings_.scene.camera.width_px);
    const double v = random.Uniform(0.0, settings_.scene.camera.height_px);
    const double range = 0.25 + 1.75 * std::sqrt(random.Uniform(0.0, 1.0));
    const Eigen::Vector3d ray_W = light.R_WC() * settings_.scene.camera.RayOf({u, v});
    const Eigen::Vector3d p_W = light.camera_W() + range * ray_W;
    const Eigen::Array3f glow = light.On(p_W, -ray_W) * light.Along(ray_W, range).direct;
    // A flake of a millimetre out of focus.
    const double sigma = 0.5 + 0.35 * random.Uniform(0.2, 1.0) / range;
    const double size = 0.0009 * random.Uniform(0.5, 1.5) * settings_.scene.camera.fx / range;
    const double peak = 0.5 * std::min(size * size / (6.0 * sigma * sigma), 1.0);
    const int reach = static_cast<int>(std::ceil(2.5 * sigma));
    for (int row = static_cast<int>(v) - reach; row <= static_cast<int>(v) + reach; ++row) {
      if (row < 0 || row >= linear_.height_px) continue;
      for (int column = static_cast<int>(u) - reach; column <= static_cast<int>(u) + reach;
           ++column) {
        if (column < 0 || column >= linear_.width_px) continue;
        const double far2 =
            (column + 0.5 - u) * (column + 0.5 - u) + (row + 0.5 - v) * (row + 0.5 - v);
        const auto cover = static_cast<float>(peak * std::exp(-0.5 * far2 / (sigma * sigma)));
        for (std::size_t c = 0; c < 3; ++c) {
          float& value = linear_.row(c, row)[column];
          value += cover * std::max(glow(static_cast<Eigen::Index>(c)) - value, 0.0F);
        }
      }
    }
  }
}

Image PictureRenderer::Render(const Pose& X_WB, std::span<const Solid> solids, std::uint32_t frame,
                              Seconds time) {
  const CameraModel& camera = settings_.scene.camera;
  labels_.clear();
  growth_.clear();
  litter_.clear();
  Eigen::Vector3d below_W = X_WB.p_WB;
  below_W.z() = relief_.At(below_W.head<2>()).depth;
  const SceneLight light({settings_.image, camera, water_, lamp_, relief_},
                         caustics_.At(below_W, time), X_WB);
  ground_.Look(light, relief_);
  clutter_.Collect(ground_.area(), relief_, growth_, litter_);
  for (const Solid& solid : solids)
    ground_.DropShadow(light, solid, towards_sun_W_);
  for (const Solid& lost : litter_)
    ground_.DropShadow(light, lost, towards_sun_W_);
  ground_.Paint(camera, X_WB, relief_, growth_, towards_sun_W_, linear_);
  PaintSolids(X_WB, solids, light);
  AddFlakes(light, frame);

  const double scattered = 1.0 - std::exp(-water_.scattering()(1) * ground_.mean_range());
  lens_.Blur(linear_, settings_.image.water.forward_scatter * scattered);
  Image image{camera.width_px, camera.height_px, {}};
  image.bgr.resize(3 * label_image_.size());
  sensor_.Develop(linear_, sensor_.Meter(linear_), frame, image);
  jpeg_.Compress(image);
  return image;
}

}  // namespace limpet
