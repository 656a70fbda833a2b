// SPDX-License-Identifier: MIT
#include "estimation/association/box_reading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace limpet {
namespace {

/// Of the full angle of the free axis, what must show along a cut one for the sphere's centre to be
/// inside the image: half, and what edges may be off. Beyond the centre the free axis shows a
/// chord.
constexpr double kMoreThanHalf = 0.6;

/// True if the border hides less than half of a box that is cut along one axis at most.
bool ShowsCentre(const BoxReading& reading) {
  if (reading.is_cut_u && reading.is_cut_v) return false;
  if (reading.is_whole()) return true;
  const int cut = reading.is_cut_u ? 0 : 1;
  return reading.half_angle(cut) >= kMoreThanHalf * reading.half_angle(1 - cut);
}

/// 1-sigma of the centre along an axis with a box of that size [px].
double CentreSigma(const Box& box, double size, const BoxNoise& noise) {
  const double doubt = 1.0 + noise.doubt * (1.0 - std::clamp(box.confidence, 0.0, 1.0));
  return (noise.floor_px + noise.share_of_size * size) * doubt;
}

/// What the axes that are cut show.
std::array<std::optional<CutAxisFactor::Measurement>, 2> CutAxes(
    const Box& box, const BoxReading& reading, const std::array<BoxExtent, 2>& extents,
    const BoxNoise& noise) {
  const double unsure = std::max(noise.sure_cap - std::clamp(box.confidence, 0.0, 1.0), 0.0);
  const double share =
      noise.edge_share * (ShowsCentre(reading) ? 1.0 : 1.0 + noise.cap_doubt * unsure);
  // The longer side tells best how large the whole box is, a free axis how well it was placed.
  const double longer = std::max(box.w, box.h);
  const double free = reading.sigma_px.minCoeff();
  const double placed = std::isfinite(free) ? free : CentreSigma(box, longer, noise);
  std::array<std::optional<CutAxisFactor::Measurement>, 2> axes;
  for (std::size_t axis = 0; axis < extents.size(); ++axis) {
    if (!extents[axis].is_cut()) continue;
    axes[axis] = CutAxisFactor::Measurement{.axis = static_cast<int>(axis),
                                            .box = extents[axis],
                                            .sigma_px = std::hypot(placed, share * longer)};
  }
  return axes;
}

Eigen::Vector2d SizePlanes(const BoxReading& reading) {
  if (reading.is_whole()) return {0.5, 0.5};
  Eigen::Vector2d planes = Eigen::Vector2d::Zero();
  const std::size_t cut = reading.is_cut_u ? 0 : 1;
  if (reading.cut_axes[cut]->box.is_half_cut() && ShowsCentre(reading))
    planes(cut == 0 ? 1 : 0) = 1.0;
  return planes;
}

}  // namespace

BoxReading ReadBox(const Box& box, const CameraModel& camera, const BoxNoise& noise) {
  BoxReading reading;
  const BoxExtent across = ExtentAcross(box, camera), along = ExtentAlong(box, camera);
  reading.is_cut_u = across.is_cut();
  reading.is_cut_v = along.is_cut();
  const auto mid = [](const BoxExtent& extent, double f, double c, double& half) {
    const double a = std::atan((extent.low - c) / f), b = std::atan((extent.high - c) / f);
    half = 0.5 * (b - a);
    return c + f * std::tan(0.5 * (a + b));
  };
  reading.centre_px = {mid(across, camera.fx, camera.cx, reading.half_angle.x()),
                       mid(along, camera.fy, camera.cy, reading.half_angle.y())};
  constexpr double kUnused = std::numeric_limits<double>::infinity();
  const auto sigma = [&](bool is_cut, double size) {
    return is_cut ? kUnused : CentreSigma(box, size, noise);
  };
  reading.sigma_px = {sigma(reading.is_cut_u, box.w), sigma(reading.is_cut_v, box.h)};
  reading.cut_axes = CutAxes(box, reading, {across, along}, noise);
  reading.size_planes_C = SizePlanes(reading);
  return reading;
}

std::optional<double> BoxReading::Range(double radius) const {
  if (!tells_size() || radius <= 0.0 || half_angle.minCoeff() < 1e-3) {
    return std::nullopt;
  }
  return radius * size_planes_C.dot(half_angle.array().sin().inverse().matrix());
}

}  // namespace limpet
