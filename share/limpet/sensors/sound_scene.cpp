// SPDX-License-Identifier: MIT
#include "limpet/sensors/sound_scene.hpp"

#include <cmath>
#include <utility>

namespace limpet {
namespace {

/// Steeper than this a ray runs onto the seabed rather than along it (60 deg from vertical).
constexpr double kSteep = 0.5;

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

SoundScene::SoundScene(std::function<double(const Eigen::Vector2d& p_W)> seabed,
                       std::vector<Sphere> spheres, std::vector<UprightBody> bodies)
    : seabed_(std::move(seabed)), spheres_(std::move(spheres)), bodies_(std::move(bodies)) {}

double SoundScene::Below(const Eigen::Vector3d& at_W) const {
  return seabed_(at_W.head<2>()) - at_W.z();
}

/// Goes on by steps until it is in the seabed, then halves the last one.
std::optional<double> SoundScene::AlongSeabed(const Eigen::Vector3d& origin_W,
                                              const Eigen::Vector3d& direction_W,
                                              double max_range) const {
  constexpr double kStep = 1.0, kClose = 0.01;  // [m]; a rise is longer than a step
  double clear = 0.0, within = 0.0;
  while (within < max_range) {
    within = std::min(max_range, clear + kStep);
    if (Below(origin_W + within * direction_W) <= 0.0) break;
    clear = within;
  }
  if (clear >= max_range) return std::nullopt;
  while (within - clear > kClose) {
    const double middle = 0.5 * (clear + within);
    (Below(origin_W + middle * direction_W) <= 0.0 ? within : clear) = middle;
  }
  return within;
}

/// Goes down to the depth that the seabed has below the last guess; converges since the seabed is
/// flatter than a steep ray.
std::optional<double> SoundScene::ToSeabed(const Eigen::Vector3d& origin_W,
                                           const Eigen::Vector3d& direction_W,
                                           double max_range) const {
  if (direction_W.z() < kSteep) return AlongSeabed(origin_W, direction_W, max_range);
  double range = 0.0;
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d at = origin_W + range * direction_W;
    const double step = Below(at) / direction_W.z();
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
  return (seabed_(far) - seabed_(near)) / (2.0 * kReach);
}

std::optional<double> SoundScene::Range(const Eigen::Vector3d& origin_W,
                                        const Eigen::Vector3d& direction_W,
                                        double max_range) const {
  std::optional<double> first = ToSeabed(origin_W, direction_W, max_range);
  const auto take = [&first](const std::optional<double>& range) {
    if (range && (!first || *range < *first)) first = range;
  };
  for (const Sphere& sphere : spheres_) {
    take(ToSphere(sphere, origin_W, direction_W));
  }
  for (const UprightBody& body : bodies_) {
    take(body.Range(origin_W, direction_W));
  }
  if (!first || *first <= 0.0 || *first > max_range) return std::nullopt;
  return first;
}

}  // namespace limpet
