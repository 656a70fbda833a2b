// SPDX-License-Identifier: MIT
#include "estimation/association/box_gate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include "estimation/smoothing/camera_point.hpp"

namespace limpet {
namespace {

constexpr double kNearestPoint = 0.3;  // [m]

/// Offset of a box along one axis from where a sphere should appear [px]; nothing if both edges are
/// cut, which tells nothing.
struct AxisOffset {
  double offset = 0.0;
  double size = 0.0;  ///< of the expected box [px]
};

std::optional<AxisOffset> OffsetAlong(double side, double depth, double radius, double f, double c,
                                      double low, double high, double centre, double image,
                                      double border) {
  const double middle = std::atan2(side, depth);
  const double half = std::asin(std::min(radius / std::hypot(side, depth), 0.99));
  const double expected_low = c + f * std::tan(std::max(middle - half, -1.5));
  const double expected_high = c + f * std::tan(std::min(middle + half, 1.5));
  const double size = expected_high - expected_low;
  const bool cuts_low = low<border, cuts_high = high> image - border;
  if (cuts_low && cuts_high) return std::nullopt;
  if (cuts_low) return AxisOffset{high - expected_high, size};
  if (cuts_high) return AxisOffset{low - expected_low, size};
  return AxisOffset{centre - (c + f * side / depth), size};
}

}  // namespace

std::optional<BoxMatch> MatchBox(const BoxDetection& box, const BoxReading& reading,
                                 const NavVector& x, const Eigen::Vector3d& p_W,
                                 const SightCovariance& covariance, double radius,
                                 bool is_same_class, const CameraModel& camera,
                                 const BoxGateParams& params) {
  const CameraPoint point = CameraPointOf(camera, x, p_W);
  const Eigen::Vector3d& p = point.p_C;
  if (p.z() < kNearestPoint) {
    return std::nullopt;
  }
  constexpr double kBorder = 2.0;
  const auto along_u =
      OffsetAlong(p.x(), p.z(), radius, camera.fx, camera.cx, box.u - 0.5 * box.w,
                  box.u + 0.5 * box.w, reading.centre_px.x(), camera.width_px, kBorder);
  const auto along_v =
      OffsetAlong(p.y(), p.z(), radius, camera.fy, camera.cy, box.v - 0.5 * box.h,
                  box.v + 0.5 * box.h, reading.centre_px.y(), camera.height_px, kBorder);

  const double k = 1.0 / p.z();
  Eigen::Matrix<double, 2, 3> J_C;
  J_C << camera.fx * k, 0.0, -camera.fx * p.x() * k * k,  //
      0.0, camera.fy * k, -camera.fy * p.y() * k * k;
  Eigen::Matrix<double, 2, 9> J;
  J << J_C * point.J_pose, J_C * point.J_landmark;
  Eigen::Matrix2d S = J * covariance * J.transpose();
  Eigen::Vector2d r = Eigen::Vector2d::Zero();
  bool overlaps = true;
  const double mean = 0.5 * S.trace(), half = 0.5 * (S(0, 0) - S(1, 1));
  const double spread = std::sqrt(mean + std::sqrt(half * half + S(0, 1) * S(0, 1)));
  BoxMatch match{.cost = 0.0,
                 .new_cost = -2.0 * std::log(params.new_object_share),
                 .distance2 = 0.0,
                 .spread_px = spread};
  const auto add_axis = [&](int axis, const std::optional<AxisOffset>& along, double sigma,
                            double image) {
    if (!along) {
      S.row(axis).setZero(), S.col(axis).setZero();
      S(axis, axis) = 1.0 / (2.0 * std::numbers::pi);
      return;
    }
    const double noise = std::isfinite(sigma) ? sigma : 4.0 + 0.15 * along->size;
    const double extra = params.model_error_px + params.model_error_share * along->size;
    S(axis, axis) += noise * noise + extra * extra;
    r(axis) = along->offset;
    overlaps = overlaps && std::abs(along->offset) < params.overlap_share * along->size;
    match.new_cost += 2.0 * std::log(image);
  };
  add_axis(0, along_u, reading.sigma_px.x(), camera.width_px);
  add_axis(1, along_v, reading.sigma_px.y(), camera.height_px);
  if (!along_u && !along_v) {
    return std::nullopt;
  }
  const double determinant = S.determinant();
  match.distance2 =
      (S(1, 1) * r(0) * r(0) - 2.0 * S(0, 1) * r(0) * r(1) + S(0, 0) * r(1) * r(1)) / determinant;
  if (const auto range = reading.Range(radius)) {
    const double expected = 0.5 * (std::hypot(p.x(), p.z()) + std::hypot(p.y(), p.z()));
    const Eigen::RowVector3d ray_C(0.0, 0.0, 1.0);
    const Eigen::RowVector3d to_object = ray_C * point.J_landmark;
    const double sd = std::sqrt((to_object * covariance.bottomRightCorner<3, 3>()).dot(to_object));
    const double sigma = std::hypot(params.range_sigma, sd / expected);
    const double off = std::log(*range / expected) / sigma;
    overlaps = overlaps && std::abs(off) < 3.0;
    match.distance2 += off * off;
  }
  if (overlaps) {
    match.distance2 = std::min(match.distance2, 0.6 * params.chi2_per_gate);
  }
  if (match.distance2 > params.chi2_per_gate) {
    return std::nullopt;
  }
  const double class_share =
      is_same_class ? 1.0 - params.confused_class_share : params.confused_class_share;
  match.cost = match.distance2 + std::log(4.0 * std::numbers::pi * std::numbers::pi * determinant) -
               2.0 * std::log(class_share);
  return match;
}

}  // namespace limpet
