// SPDX-License-Identifier: MIT
#include "limpet/imaging/growth_form.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {
namespace {

constexpr float kSkyShare = 0.45F;

float Length(float a, float b) { return std::sqrt(a * a + b * b); }

float Soft(float edge, float at, float width) {
  return std::clamp(0.5F + (edge - at) / width, 0.0F, 1.0F);
}

/// Radius of a stone's outline towards (a, b): three lobes and five.
float StoneEdge(const Growth& growth, float a, float b) {
  const float angle = std::atan2(b, a);
  return 0.86F + 0.10F * std::sin(3.0F * angle + 6.0F * growth.form) +
         0.05F * std::sin(5.0F * angle + 17.0F * growth.form);
}

GrowthSample Stone(const Growth& growth, float east, float north, float a, float b,
                   const Eigen::Vector3f& sun) {
  const float far = Length(a, b);
  const float edge = far < 1.25F ? StoneEdge(growth, a, b) : 1.0F;
  if (far < edge) {
    const float share = far / edge;
    Eigen::Vector3f normal(east, north, 0.9F * std::sqrt(std::max(1.0F - share * share, 0.02F)));
    normal.normalize();
    const float facing = std::max(normal.dot(sun), 0.0F) / sun.z();
    const float mottle = 1.0F + 0.14F * std::sin(9.0F * a + 31.0F * growth.form) *
                                    std::sin(11.0F * b - 3.0F * a + 7.0F * growth.form);
    const float light =
        mottle * (kSkyShare * (0.55F + 0.45F * normal.z()) + (1.0F - kSkyShare) * facing);
    return {Soft(edge, far, 0.06F), light * growth.color};
  }
  // Its shadow falls away from the sun; nothing of the sky reaches under it.
  const float x = east + 0.45F * sun.x() / sun.z();
  const float y = north + 0.45F * sun.y() / sun.z();
  const float shadow = 0.6F * Soft(0.86F, Length(x, y), 0.25F);
  const float foot = 0.5F * Soft(1.10F * edge, far, 0.35F);
  return {std::max(shadow, foot), Eigen::Array3f::Zero()};
}

GrowthSample Starfish(const Growth& growth, float a, float b) {
  const float far = Length(a, b);
  const float arm = 0.5F + 0.5F * std::cos(5.0F * std::atan2(b, a));
  const float edge = 0.24F + 0.76F * arm * arm * std::sqrt(arm);
  const float ridge = 1.15F - 0.55F * std::min(far / edge, 1.0F);
  const float warts = 1.0F + 0.12F * std::sin(28.0F * a) * std::sin(28.0F * b);
  return {Soft(edge, far, 0.06F), ridge * warts * growth.color};
}

GrowthSample Plant(const Growth& growth, float a, float b) {
  const float far = Length(a, b);
  const float angle = std::atan2(b, a);
  GrowthSample sample;
  // Two whorls of leaves, the inner on top and brighter.
  for (int whorl = 0; whorl < 2; ++whorl) {
    const float leaves = whorl == 0 ? 9.0F : 7.0F;
    const float curl = (whorl == 0 ? 1.3F : -1.0F) * (growth.form - 0.5F) * 3.0F;
    const float phase =
        leaves * (angle + curl * far) + 11.0F * growth.form + static_cast<float>(whorl);
    const float length =
        (whorl == 0 ? 1.0F : 0.72F) * (0.85F + 0.15F * std::sin(2.3F * angle + phase));
    const float width = 1.15F - 0.9F * far / length;  // pointed leaves
    const float inside = std::cos(phase) - (1.0F - width);
    const float cover = std::clamp(3.0F * inside, 0.0F, 1.0F) * Soft(length, far, 0.1F);
    if (cover > sample.cover * 0.8F) {
      const float vein = 0.75F + 0.25F * std::cos(phase);
      sample = {cover, (0.35F + 0.75F * far) * vein * growth.color};
    }
  }
  return sample;
}

GrowthSample Urchin(const Growth& growth, float a, float b) {
  const float far = Length(a, b);
  const float spines = 0.55F + 0.45F * std::abs(std::cos(13.0F * std::atan2(b, a) + 9.0F * far));
  return {0.92F * Soft(spines, far, 0.15F), growth.color * (0.6F + 0.8F * far)};
}

GrowthSample Shell(const Growth& growth, float a, float b) {
  const float far = Length(a, 1.25F * b);
  const float ribs = 0.82F + 0.18F * std::cos(26.0F * std::atan2(b, a + 0.9F));
  return {Soft(0.9F, far, 0.15F), ribs * (1.0F - 0.25F * far) * growth.color};
}

}  // namespace

GrowthSample GrowthAt(const Growth& growth, float east, float north,
                      const Eigen::Vector3f& towards_sun_W) {
  constexpr float kLeafTips = 1.05F;  // nothing but a stone's shadow is farther out
  if (growth.kind != GrowthKind::kStone && east * east + north * north > kLeafTips * kLeafTips) {
    return {};
  }
  const float cosine = std::cos(growth.turn);
  const float sine = std::sin(growth.turn);
  const float a = cosine * east + sine * north;
  const float b = cosine * north - sine * east;
  switch (growth.kind) {
    case GrowthKind::kStone:
      return Stone(growth, east, north, a, b, towards_sun_W);
    case GrowthKind::kStarfish:
      return Starfish(growth, a, b);
    case GrowthKind::kPlant:
      return Plant(growth, a, b);
    case GrowthKind::kUrchin:
      return Urchin(growth, a, b);
    case GrowthKind::kShell:
      return Shell(growth, a, b);
  }
  return {};
}

}  // namespace limpet
