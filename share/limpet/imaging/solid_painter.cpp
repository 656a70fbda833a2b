// SPDX-License-Identifier: MIT
#include "limpet/imaging/solid_painter.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/random.hpp"
#include "limpet/imaging/solid_image.hpp"
#include "limpet/imaging/tile_noise.hpp"
#include "limpet/objects/color_table.hpp"
#include "limpet/vision/water_optics.hpp"

namespace limpet {
namespace {

Eigen::Array3f PaintOf(const std::string& color) {
  const Albedo paint = AlbedoOf(color).value_or(Albedo{0.3F, 0.3F, 0.3F});
  return {paint[0], paint[1], paint[2]};
}

/// One value per 11 cm over 7 m that repeat: of all solids, each reads it elsewhere.
const TileNoise& FoulingNoise() {
  static const TileNoise kNoise = [] {
    Random random(1, "fouling");
    return TileNoise(64, 7.04, random);
  }();
  return kNoise;
}

}  // namespace

std::optional<SolidPainter> SolidPainter::Make(const CameraModel& camera, const Pose& X_WB,
                                               const Solid& solid, const SceneLight& light) {
  const std::optional<PixelRect> outline = OutlineOf(camera, X_WB, solid);
  const bool is_inside = outline && outline->right > 0.0 && outline->bottom > 0.0 &&
                         outline->left < camera.width_px && outline->top < camera.height_px;
  if (!is_inside) return std::nullopt;
  const double range = (solid.p_W - light.camera_W()).norm();
  const Eigen::Vector3d ray_W = (solid.p_W - light.camera_W()) / range;
  if (light.Along(ray_W, range).direct.maxCoeff() < static_cast<float>(kLeastTransmission))
    return std::nullopt;
  return SolidPainter(camera, X_WB, solid, light, *outline);
}

SolidPainter::SolidPainter(const CameraModel& camera, const Pose& X_WB, const Solid& solid,
                           const SceneLight& light, const PixelRect& outline)
    : solid_(&solid),
      light_(&light),
      camera_(camera),
      outline_(outline),
      R_SC_(solid.R_WS.transpose() * RotationOf(X_WB) * camera.R_BC),
      camera_S_(solid.R_WS.transpose() * (light.camera_W() - solid.p_W)),
      range_(camera_S_.norm()),
      bound_(solid.BoundingRadius()),
      touches_seabed_(solid.p_W.z() + bound_ > light.SeabedDepthAt(solid.p_W)),
      paint_(PaintOf(solid.color)),
      band_paint_(solid.band_color.empty() ? paint_ : PaintOf(solid.band_color)),
      blotches_(static_cast<float>(std::fmod(std::abs(3.1 * solid.p_W.x() + solid.p_W.y()), 7.0))) {
  const Eigen::Vector3d ray_W = (solid.p_W - light.camera_W()) / range_;
  near_ = light.Along(ray_W, range_ - bound_);
  far_ = light.Along(ray_W, range_ + bound_);
}

/// Walks by the distance to the surface. The form is taken half a pixel smaller and its edge one
/// pixel wide, so that silhouettes are smooth and of the right size.
SolidPainter::Sample SolidPainter::Walk(const Eigen::Vector3d& ray_S, double pixel_angle) const {
  const double middle = -camera_S_.dot(ray_S);
  const double passes2 = camera_S_.squaredNorm() - middle * middle;
  const double reach = bound_ + pixel_angle * middle;
  if (passes2 >= reach * reach) return {};
  const double half = std::sqrt(reach * reach - passes2);
  double nearest = 1.0;
  double range_of_nearest = middle;
  double range = std::max(middle - half, 0.0);
  constexpr int kMostSteps = 48;
  for (int step = 0; step < kMostSteps && range < middle + half; ++step) {
    const double pixel = pixel_angle * range;
    const double distance = solid_->DistanceTo(camera_S_ + range * ray_S) + 0.5 * pixel;
    if (distance < nearest * pixel) {
      nearest = distance / pixel;
      range_of_nearest = range;
    }
    if (distance < 0.02 * pixel) return {1.0, range};
    range += std::max(distance, 0.02 * pixel);
  }
  return {1.0 - nearest, range_of_nearest};
}

/// Paint that has been in the sea: blotches, a film of algae, dust on what faces up.
Eigen::Array3f SolidPainter::AlbedoAt(const Eigen::Vector3d& p_S, double up) const {
  const bool is_band = std::abs(p_S.z()) < solid_->height / 6.0;
  const Eigen::Array3f paint = is_band ? band_paint_ : paint_;
  // A slanted cut through the form: blotches on every side, without a third dimension.
  const auto a = static_cast<float>(p_S.x() + 0.7 * p_S.z());
  const auto b = static_cast<float>(p_S.y() - 0.8 * p_S.z());
  const TileNoise& noise = FoulingNoise();
  const float blotch = 0.6F * noise.At(blotches_ + a, blotches_ + b) +
                       0.4F * noise.At(blotches_ + 3.7F * b, 3.7F * a);
  const Eigen::Array3f film(0.03F, 0.07F, 0.05F);
  const float share = std::clamp(0.10F + 0.30F * blotch, 0.0F, 0.6F);
  const auto dust = static_cast<float>(0.12 * std::max(up - 0.3, 0.0));
  const Eigen::Array3f sand(0.16F, 0.21F, 0.24F);
  return (1.0F - dust) * ((1.0F - share) * paint + share * film) + dust * sand;
}

int SolidPainter::Paint(LinearImage& image, std::uint8_t* labels, std::uint8_t label) const {
  const int left = std::clamp(static_cast<int>(std::floor(outline_.left)) - 1, 0, image.width_px);
  const int right = std::clamp(static_cast<int>(std::ceil(outline_.right)) + 1, 0, image.width_px);
  const int top = std::clamp(static_cast<int>(std::floor(outline_.top)) - 1, 0, image.height_px);
  const int bottom =
      std::clamp(static_cast<int>(std::ceil(outline_.bottom)) + 1, 0, image.height_px);
  const double pixel_at_axis = 2.0 / (camera_.fx + camera_.fy);
  int pixels = 0;
  for (int row = top; row < bottom; ++row) {
    for (int column = left; column < right; ++column) {
      const Eigen::Vector3d ray_C = camera_.RayOf({column + 0.5, row + 0.5});
      const Sample sample = Walk(R_SC_ * ray_C, pixel_at_axis * ray_C.z());
      if (sample.coverage <= 0.0) continue;
      const Eigen::Vector3d ray_W = light_->R_WC() * ray_C;
      const Eigen::Vector3d hit_W = light_->camera_W() + sample.range * ray_W;
      if (touches_seabed_ && hit_W.z() > light_->SeabedDepthAt(hit_W)) continue;
      const Eigen::Vector3d hit_S = solid_->R_WS.transpose() * (hit_W - solid_->p_W);
      const Eigen::Vector3d normal_W = solid_->R_WS * solid_->NormalAt(hit_S);
      const auto depth = static_cast<float>((sample.range - range_ + bound_) / (2.0 * bound_));
      const Eigen::Array3f direct = near_.direct + depth * (far_.direct - near_.direct);
      const Eigen::Array3f veil = near_.veil + depth * (far_.veil - near_.veil);
      const Eigen::Array3f glow =
          static_cast<float>(light_->VignetteOf({column + 0.5, row + 0.5})) *
          (AlbedoAt(hit_S, -normal_W.z()) * light_->On(hit_W, normal_W) * direct + veil);
      const auto coverage = static_cast<float>(sample.coverage);
      for (std::size_t c = 0; c < 3; ++c) {
        float& value = image.row(c, row)[column];
        value += coverage * (glow(static_cast<Eigen::Index>(c)) - value);
      }
      if (coverage <= 0.5F) continue;
      labels[row * image.width_px + column] = label;
      ++pixels;
    }
  }
  return pixels;
}

}  // namespace limpet
