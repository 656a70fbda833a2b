// SPDX-License-Identifier: MIT
#include "limpet/sensors/true_sheets.hpp"

namespace limpet {

ImuSheet TrueSheet(ImuSheet sheet, const SheetErrorParams& error) {
  sheet.gyro_noise_radps *= error.noise_factor;
  sheet.force_noise_mps2 *= error.noise_factor;
  sheet.gyro_bias_radps *= error.bias_factor;
  sheet.force_bias_mps2 *= error.bias_factor;
  sheet.heading_sigma = error.bias_factor * sheet.heading_sigma;
  return sheet;
}

FogSheet TrueSheet(FogSheet sheet, const SheetErrorParams& error) {
  sheet.random_walk *= error.noise_factor;
  sheet.bias_deg_per_h *= error.bias_factor;
  return sheet;
}

DvlSheet TrueSheet(DvlSheet sheet, const SheetErrorParams& error) {
  sheet.noise_mps *= error.noise_factor;
  sheet.vertical_noise_mps *= error.noise_factor;
  sheet.range_noise_m *= error.noise_factor;
  sheet.range_noise_share *= error.noise_factor;
  sheet.scale_sigma *= error.bias_factor;
  sheet.misalignment_sigma = error.bias_factor * sheet.misalignment_sigma;
  sheet.bias_mps *= error.bias_factor;
  return sheet;
}

DepthSheet TrueSheet(DepthSheet sheet, const SheetErrorParams& error) {
  sheet.noise_m *= error.noise_factor;
  sheet.bias_m *= error.bias_factor;
  return sheet;
}

}  // namespace limpet
