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

/// Of a box that one axis is free of: that the border hides less than half.
bool ShowsCentre(const BoxReading& reading) {
  const int cut = reading.is_cut_u ? 0 : 1;
  return reading.half_angle(cut) >= kMoreThanHalf * reading.half_angle(1 - cut);
}

/// The edge of the cut axis that shows, if the other axis is whole.
std::optional<EdgeFactor::Edge> LoneEdge(const Box& box, const BoxReading& reading,
                                         const std::array<BoxExtent, 2>& extents,
                                         const BoxNoise& noise) {
  const int axis = reading.is_cut_u ? 0 : 1;
  const BoxExtent& extent = extents[static_cast<std::size_t>(axis)];
  if (reading.is_cut_u == reading.is_cut_v || !extent.is_half_cut()) {
    return std::nullopt;
  }
  const double unsure = std::max(noise.sure_cap - std::clamp(box.confidence, 0.0, 1.0), 0.0);
  const double share =
      noise.edge_share * (ShowsCentre(reading) ? 1.0 : 1.0 + noise.cap_doubt * unsure);
  // The free axis tells how large the whole box is, and how sure the detector was of it.
  const double whole = std::max(box.w, box.h);
  return EdgeFactor::Edge{.axis = axis,
                          .side = extent.is_low_cut ? 1 : -1,
                          .measured_px = extent.shown_edge(),
                          .sigma_px = std::hypot(reading.sigma_px(1 - axis), share * whole)};
}

Eigen::Vector2d SizePlanes(const BoxReading& reading) {
  if (reading.is_whole()) return {0.5, 0.5};
  Eigen::Vector2d planes = Eigen::Vector2d::Zero();
  if (reading.lone_edge && ShowsCentre(reading)) planes(1 - reading.lone_edge->axis) = 1.0;
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
  const double doubt = 1.0 + noise.doubt * (1.0 - std::clamp(box.confidence, 0.0, 1.0));
  constexpr double kUnused = std::numeric_limits<double>::infinity();
  const auto sigma = [&](bool is_cut, double size) {
    return is_cut ? kUnused : (noise.floor_px + noise.share_of_size * size) * doubt;
  };
  reading.sigma_px = {sigma(reading.is_cut_u, box.w), sigma(reading.is_cut_v, box.h)};
  reading.lone_edge = LoneEdge(box, reading, {across, along}, noise);
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
