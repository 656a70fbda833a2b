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

/// One of those that shade makes look like one another: yellow, orange, red.
[[nodiscard]] bool IsWarm(const PaintClass& paint);

/// Which warm paint a surface has that may be in shade, by its colour `inside` and that of the
/// ground beside it, blue, green, red [levels]. Nothing if neither is redder than the other.
///
/// Shade s leaves s paint - ground of the difference: dim yellow looks orange, dim orange red. In
/// light over the ground's light, per channel, the ground is 1 (Weber's contrast): the difference
/// of two channels loses it, and the ratio of two such differences loses the shade, the light's
/// colour and the camera's gains too. What is left is green over red of the paint, by that of the
/// ground: of sand where the water is clear, of water where it is not. Half of the colour that the
/// ground is seen to have is taken for its own.
[[nodiscard]] std::optional<PaintClass> ClassifyWarmInShade(const Eigen::Vector3d& inside,
                                                            const Eigen::Vector3d& outside);

}  // namespace limpet
