// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

namespace limpet {

struct PaintClass {
  std::string color;
  double certainty = 0.0;  ///< 0 between two paints, 1 far from any other
};

/// The paint whose contrast against water and seabed looks like this one: by the signs and ratios
/// of the colour differences, which haze only scales. Nothing if no paint does, such as a dark
/// stone.
[[nodiscard]] std::optional<PaintClass> ClassifyPaint(const Eigen::Vector3d& difference);

}  // namespace limpet
