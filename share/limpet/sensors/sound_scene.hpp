// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limpet/simulation/upright_body.hpp"

namespace limpet {

/// What sound meets: the seabed, spheres in the water, and what stands up from the seabed.
class SoundScene {
 public:
  struct Sphere {
    Eigen::Vector3d center_W;
    double radius = 0.5;
  };
  SoundScene(std::function<double(const Eigen::Vector2d& p_W)> seabed, std::vector<Sphere> spheres,
             std::vector<UprightBody> bodies = {});

  /// Distance [m] along a ray (`direction_W` of unit length) to what it meets first, if that lies
  /// within `max_range`.
  [[nodiscard]] std::optional<double> Range(const Eigen::Vector3d& origin_W,
                                            const Eigen::Vector3d& direction_W,
                                            double max_range) const;
  /// How much the seabed falls along a ray's way over ground, per metre, where `range` [m] ends.
  [[nodiscard]] double SlopeAlong(const Eigen::Vector3d& origin_W,
                                  const Eigen::Vector3d& direction_W, double range) const;

 private:
  [[nodiscard]] std::optional<double> ToSeabed(const Eigen::Vector3d& origin_W,
                                               const Eigen::Vector3d& direction_W,
                                               double max_range) const;
  [[nodiscard]] std::optional<double> AlongSeabed(const Eigen::Vector3d& origin_W,
                                                  const Eigen::Vector3d& direction_W,
                                                  double max_range) const;
  /// How far the seabed is below a place [m].
  [[nodiscard]] double Below(const Eigen::Vector3d& at_W) const;

  std::function<double(const Eigen::Vector2d&)> seabed_;
  std::vector<Sphere> spheres_;
  std::vector<UprightBody> bodies_;
};

}  // namespace limpet
