// SPDX-License-Identifier: MIT
#include "limpet/imaging/scene_light.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/imaging/lens.hpp"

namespace limpet {
namespace {

/// Share of daylight under water that comes from the whole sky.
constexpr float kFromSky = 0.45F;

}  // namespace

Eigen::Vector3d TowardsSun(const ImageParams::Light& light) {
  const double level = std::cos(light.elevation.value());
  return {level * std::cos(light.azimuth.value()), level * std::sin(light.azimuth.value()),
          -std::sin(light.elevation.value())};
}

SceneLight::SceneLight(const Scene& scene, Caustics::Layer caustics, const Pose& X_WB)
    : params_(scene.params),
      camera_(scene.camera),
      water_(&scene.water),
      lamp_(&scene.lamp),
      caustics_(caustics),
      relief_(&scene.relief),
      R_WC_(RotationOf(X_WB) * camera_.R_BC),
      camera_W_(X_WB.p_WB + RotationOf(X_WB) * camera_.p_BC),
      sun_W_(TowardsSun(params_.light)),
      daylight_(DaylightAt(camera_W_.z())) {}

SceneLight::Path SceneLight::Along(const Eigen::Vector3d& ray_W, double range) const {
  Eigen::Array3f veil = daylight_ * water_->Veil(range, ray_W);
  if (lamp_->is_on()) veil += lamp_->Veil(range);
  return {water_->Direct(range), veil};
}

Eigen::Array3f SceneLight::DaylightAt(double depth) const {
  return static_cast<float>(params_.light.sun) * water_->Daylight(depth);
}

Eigen::Array3f SceneLight::LampOn(const Eigen::Vector3d& p_W,
                                  const Eigen::Vector3d& normal_W) const {
  if (!lamp_->is_on()) return Eigen::Array3f::Zero();
  const Eigen::Vector3d p_C = R_WC_.transpose() * (p_W - camera_W_);
  const double facing = std::max((R_WC_ * lamp_->TowardsLamp(p_C)).dot(normal_W), 0.0);
  return static_cast<float>(facing) * lamp_->LightAt(p_C);
}

Eigen::Array3f SceneLight::On(const Eigen::Vector3d& p_W, const Eigen::Vector3d& normal_W) const {
  const auto up = static_cast<float>(-normal_W.z());
  const auto facing = static_cast<float>(std::max(normal_W.dot(sun_W_), 0.0) / -sun_W_.z());
  // From below comes what the seabed returns.
  const float sky = kFromSky * (0.5F + 0.5F * up) + 0.08F * (0.5F - 0.5F * up);
  const float waves = facing > 0.0F ? caustics_.LightAt(p_W.head<2>()) : 1.0F;
  return DaylightAt(p_W.z()) * (sky + (1.0F - kFromSky) * facing * waves) + LampOn(p_W, normal_W);
}

SceneLight::Ground SceneLight::OnGround(const Eigen::Vector3d& p_W,
                                        const Eigen::Vector3d& normal_W) const {
  const double facing = std::clamp(normal_W.dot(sun_W_) / -sun_W_.z(), 0.3, 1.7);
  const Eigen::Array3f sky = kFromSky * DaylightAt(p_W.z());
  const Eigen::Array3f sun = (1.0F - kFromSky) / kFromSky * static_cast<float>(facing) * sky;
  const Eigen::Array3f all = sky + sun + LampOn(p_W, normal_W);
  return {all, sun(1) / std::max(all(1), 1e-9F)};
}

double SceneLight::VignetteOf(const Eigen::Vector2d& at_px) const {
  const double du = at_px.x() - camera_.cx;
  const double dv = at_px.y() - camera_.cy;
  return VignetteAt(params_.lens,
                    (du * du + dv * dv) / (camera_.cx * camera_.cx + camera_.cy * camera_.cy));
}

}  // namespace limpet
