// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/figures/palette.hpp"
#include "limpet/figures/svg_canvas.hpp"

namespace limpet::chart {

/// Where a chart over time begins, and how wide it is.
inline constexpr double kLeft = 76.0, kWidth = 814.0;
/// Paint of the band of three standard deviations, as the estimator says them.
inline constexpr Paint kBounds{.fill = palette::kSky, .opacity = 0.3};

}  // namespace limpet::chart
