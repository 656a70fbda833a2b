// SPDX-License-Identifier: MIT
#include "limpet/sensors/sound_scene.hpp"

#include <cmath>
#include <utility>

namespace limpet {
namespace {

/// Shallower than this a ray runs along the seabed rather than onto it (60 deg from vertical).
constexpr double kLeastDescent = 0.5;

std::optional<double> ToSphere(const SoundScene::Sphere& sphere, const Eigen::Vector3d& origin_W,
                               const Eigen::Vector3d& direction_W) {
  const Eigen::Vector3d to_center = sphere.center_W - origin_W;
  const double nearest = to_center.dot(direction_W);
  const double half_chord_sq =
      sphere.radius * sphere.radius - (to_center.squaredNorm() - nearest * nearest);
  if (nearest <= 0.0 || half_chord_sq < 0.0) return std::nullopt;
  return nearest - std::sqrt(half_chord_sq);
}

}  // namespace

SoundScene::SoundScene(std::function<double(double, double)> seabed, std::vector<Sphere> spheres)
    : seabed_(std::move(seabed)), spheres_(std::move(spheres)) {}

/// Goes down to the depth that the seabed has below the last guess; converges since the seabed is
/// flatter than the ray.
std::optional<double> SoundScene::ToSeabed(const Eigen::Vector3d& origin_W,
                                           const Eigen::Vector3d& direction_W) const {
  if (direction_W.z() < kLeastDescent) return std::nullopt;
  double range = 0.0;
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d at = origin_W + range * direction_W;
    const double step = (seabed_(at.x(), at.y()) - at.z()) / direction_W.z();
    range += step;
    if (std::abs(step) < 1e-4) break;
  }
  return range;
}

double SoundScene::SlopeAlong(const Eigen::Vector3d& origin_W, const Eigen::Vector3d& direction_W,
                              double range) const {
  constexpr double kReach = 0.25;  // [m] either way: about what a beam lights up
  const Eigen::Vector2d at = (origin_W + range * direction_W).head<2>();
  const Eigen::Vector2d way = direction_W.head<2>().normalized();
  const Eigen::Vector2d far = at + kReach * way, near = at - kReach * way;
  return (seabed_(far.x(), far.y()) - seabed_(near.x(), near.y())) / (2.0 * kReach);
}

std::optional<double> SoundScene::Range(const Eigen::Vector3d& origin_W,
                                        const Eigen::Vector3d& direction_W,
                                        double max_range) const {
  std::optional<double> first = ToSeabed(origin_W, direction_W);
  for (const Sphere& sphere : spheres_) {
    const std::optional<double> range = ToSphere(sphere, origin_W, direction_W);
    if (range && (!first || *range < *first)) first = range;
  }
  if (!first || *first <= 0.0 || *first > max_range) return std::nullopt;
  return first;
}

}  // namespace limpet
