// SPDX-License-Identifier: MIT
#include "limpet/imaging/lamp.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {

Lamp::Lamp(const ImageParams::Light& light, const WaterColumn& water)
    : power_(light.lamp),
      beam_(light.lamp_beam.value()),
      water_(water),
      // Aft of a camera that looks down is below the image's middle.
      place_C_(0.0, light.lamp_off, 0.0) {
  // Straight back comes only what is scattered once: a quarter of what daylight sends upwards.
  const Eigen::Array3f per_meter = 0.25F * water.BackscatterPerMeter();
  Eigen::Array3f sum = Eigen::Array3f::Zero();
  constexpr int kParts = 10;  // of a step: near the lens the light changes fast
  veil_.push_back(sum);
  for (double range = 0.0; range < kFarthest; range += kStep) {
    for (int part = 0; part < kParts; ++part) {
      const double s = range + (part + 0.5) * kStep / kParts;
      sum += static_cast<float>(kStep / kParts) * per_meter * LightAt({0.0, 0.0, s}) *
             water_.Direct(s);
    }
    veil_.push_back(sum);
  }
}

Eigen::Array3f Lamp::LightAt(const Eigen::Vector3d& p_C) const {
  const Eigen::Vector3d ray = p_C - place_C_;
  // A lamp has a size: nearer than this it dazzles no more.
  constexpr double kNearest = 0.15;
  const double distance = std::max(ray.norm(), kNearest);
  const double off_axis = std::acos(std::clamp(ray.z() / distance, -1.0, 1.0));
  const double profile = std::exp(-0.5 * off_axis * off_axis / (beam_ * beam_));
  return static_cast<float>(power_ * profile / (distance * distance)) * water_.Direct(distance);
}

Eigen::Array3f Lamp::Veil(double range) const {
  const double at = std::clamp(range / kStep, 0.0, static_cast<double>(veil_.size() - 1));
  const auto below = std::min(static_cast<std::size_t>(at), veil_.size() - 2);
  const auto rest = static_cast<float>(at - static_cast<double>(below));
  return (1.0F - rest) * veil_[below] + rest * veil_[below + 1];
}

}  // namespace limpet
