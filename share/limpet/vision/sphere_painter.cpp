// SPDX-License-Identifier: MIT
#include "limpet/vision/sphere_painter.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/vision/water_optics.hpp"

namespace limpet {

std::optional<SpherePainter> SpherePainter::Make(const CameraModel& camera, const Pose& X_WB,
                                                 const Sphere& sphere, const WaterOptics& water,
                                                 SeabedRelief& relief) {
  const Eigen::Vector3d p_C = camera.InCamera(X_WB, sphere.p_W);
  const std::optional<SphereImage> image = ImageOfSphere(camera, p_C, sphere.radius);
  if (!image || std::exp(-water.attenuation_per_m[1] * image->range) < kLeastTransmission) {
    return std::nullopt;
  }
  return SpherePainter(camera, X_WB, sphere, water, relief, *image);
}

SpherePainter::SpherePainter(const CameraModel& camera, const Pose& X_WB, const Sphere& sphere,
                             const WaterOptics& water, SeabedRelief& relief,
                             const SphereImage& image)
    : camera_(camera),
      water_(water),
      relief_(&relief),
      image_(image),
      p_C_(camera.InCamera(X_WB, sphere.p_W)),
      radius_(sphere.radius),
      albedo_(AlbedoOf(sphere.color).value_or(Albedo{0.3F, 0.3F, 0.3F})),
      R_WC_(RotationOf(X_WB) * camera.R_BC),
      camera_W_(X_WB.p_WB + RotationOf(X_WB) * camera.p_BC),
      light_C_(R_WC_.transpose() * Eigen::Vector3d(0.20, 0.15, -0.97).normalized()),
      fx_(camera.fx),
      fy_(camera.fy) {
  for (std::size_t c = 0; c < 3; ++c) {
    transmission_[c] = std::exp(-water.attenuation_per_m[c] * image.range);
  }
  // From above, the seabed can only hide what is near the equator or lower.
  touches_seabed_ = sphere.p_W.z() + 0.3 * sphere.radius > relief.At(sphere.p_W.head<2>()).depth;
}

int SpherePainter::first_row() const {
  return std::clamp(static_cast<int>(std::floor(image_.outline.top - 1.0)), 0, camera_.height_px);
}

int SpherePainter::last_row() const {
  return std::clamp(static_cast<int>(std::ceil(image_.outline.bottom + 1.0)), 0, camera_.height_px);
}

SpherePainter::Sample SpherePainter::Trace(const Eigen::Vector3d& ray_C) const {
  const double along = ray_C.dot(p_C_);
  const double length2 = ray_C.squaredNorm();
  const double passes2 = p_C_.squaredNorm() - along * along / length2;
  const double pixels = 0.5 * (fx_ + fy_) / p_C_.z();
  const double miss = std::sqrt(std::max(passes2, 0.0)) - radius_;
  const double depth2 = std::max(radius_ * radius_ - passes2, 0.0);
  return {.coverage = std::clamp(0.5 - miss * pixels, 0.0, 1.0),
          .hit = ray_C * (along / length2 - std::sqrt(depth2 / length2))};
}

bool SpherePainter::IsBuried(const Eigen::Vector3d& hit_C) {
  const Eigen::Vector3d p_W = camera_W_ + R_WC_ * hit_C;
  return p_W.z() > relief_->At(p_W.head<2>()).depth;
}

void SpherePainter::PaintRow(int row, double vignette_curve, LinearRow& linear) {
  const double v = row + 0.5;
  const double y = (v - camera_.cy) / fy_;
  const std::optional<Chord> chord = ChordOfSphere(camera_, v, p_C_, radius_);
  // A row that misses the outline by less than a pixel still shows a little of it.
  const double left = chord ? chord->left : image_.outline.left;
  const double right = chord ? chord->right : image_.outline.right;
  const int first = std::max(static_cast<int>(std::floor(left)) - 1, 0);
  const int last = std::min(static_cast<int>(std::ceil(right)) + 1, camera_.width_px);
  for (int column = first; column < last; ++column) {
    const double u = column + 0.5;
    const Sample sample = Trace({(u - camera_.cx) / fx_, y, 1.0});
    if (sample.coverage <= 0.0 || (touches_seabed_ && IsBuried(sample.hit))) {
      continue;
    }
    const Eigen::Vector3d normal = (sample.hit - p_C_) / radius_;
    const double light = 0.40 + 0.60 * std::max(normal.dot(light_C_), 0.0);
    const double nearer = image_.range - sample.hit.norm();
    const double du = u - camera_.cx;
    const double dv = v - camera_.cy;
    const double vignette = 4095.0 * (1.0 - vignette_curve * (du * du + dv * dv));
    for (std::size_t c = 0; c < 3; ++c) {
      const double gain = water_.attenuation_per_m[c] * nearer;
      const double left_over = std::min(transmission_[c] * (1.0 + gain * (1.0 + 0.5 * gain)), 1.0);
      const double glow = left_over * albedo_[c] * light * water_.illumination[c] +
                          (1.0 - left_over) * water_.veil[c];
      float& value = linear[c][static_cast<std::size_t>(column)];
      value += static_cast<float>(sample.coverage * (vignette * glow - value));
    }
  }
}

}  // namespace limpet
