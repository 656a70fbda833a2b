// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "limpet/core/units.hpp"

namespace limpet {

/// Light gathered by the waves of the surface: rays of a vertical sun refracted by a sum of waves
/// and counted where they land. A tile that repeats; two of them that drift across each other give
/// a pattern that changes and never repeats soon. The mean is 1.
class Caustics {
 public:
  /// `contrast`: standard deviation 1 m below the surface. Equal seeds give equal light.
  Caustics(double contrast, std::uint64_t seed);

  /// What multiplies sunlight near a place on the seabed, at one time.
  class Layer;
  /// What does not vary within a frame taken above `p_W` on the seabed.
  [[nodiscard]] Layer At(const Eigen::Vector3d& p_W, Seconds time) const;

 private:
  static constexpr int kSize = 256;     ///< texels per side
  static constexpr double kTile = 3.2;  ///< side [m]
  [[nodiscard]] float Sample(float across, float along) const;

  double contrast_;
  std::vector<float> tile_;  ///< deviation from the mean, standard deviation 1
};

/// The light of one frame. Valid as long as its Caustics.
class Caustics::Layer {
 public:
  /// 0 or more; 1 in the mean.
  [[nodiscard]] float LightAt(const Eigen::Vector2d& p_W) const;
  [[nodiscard]] bool is_flat() const { return amplitude_ <= 0.0F; }

 private:
  friend class Caustics;
  Layer(const Caustics& caustics, const Eigen::Vector3d& p_W, Seconds time);
  const Caustics* caustics_;
  float amplitude_;
  double north_, east_;  ///< where the offsets below belong to [m]
  float first_along_, first_across_, second_along_, second_across_;  ///< [texel]
};

}  // namespace limpet
