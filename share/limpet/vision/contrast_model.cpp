// SPDX-License-Identifier: MIT
#include "limpet/vision/contrast_model.hpp"

#include <array>
#include <cmath>

#include "limpet/vision/water_optics.hpp"

namespace limpet {

ContrastModel::ContrastModel(double visibility_m, Random& site)
    : visibility_m_(visibility_m), close_by_(kCloseBy * std::exp(site.Normal(kSiteSpread))) {}

GroundContrast ContrastModel::Draw(double range, Random& random) const {
  const std::array<double, 3> fading = WaterOptics::OfVisibility(visibility_m_).attenuation_per_m;
  const double here = close_by_ * std::exp(random.Normal(kPatchSpread));
  const auto contrast = [&](double per_m) {
    return std::hypot(here * std::exp(-per_m * range), kOtherContrast);
  };
  return {.exposure = 0.0,
          .blue = contrast(fading[0]),
          .green = contrast(fading[1]),
          .red = contrast(fading[2]),
          .noise = kNoise};
}

}  // namespace limpet
