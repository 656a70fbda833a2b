// SPDX-License-Identifier: MIT
#include "limpet/core/lens_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

constexpr double kFarthestView = 10.0;  // beyond it no lens sees: 84 deg from its axis

Eigen::Matrix2d Derivative(const LensDistortion& lens, const Eigen::Vector2d& p) {
  const double x = p.x(), y = p.y(), r2 = p.squaredNorm();
  const double radial = 1.0 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
  const double slope = 2.0 * (lens.k1 + r2 * (2.0 * lens.k2 + r2 * 3.0 * lens.k3));  // by r2, twice
  Eigen::Matrix2d J;
  J(0, 0) = radial + slope * x * x + 2.0 * lens.p1 * y + 6.0 * lens.p2 * x;
  J(0, 1) = slope * x * y + 2.0 * lens.p1 * x + 2.0 * lens.p2 * y;
  J(1, 0) = J(0, 1);
  J(1, 1) = radial + slope * y * y + 6.0 * lens.p1 * y + 2.0 * lens.p2 * x;
  return J;
}

Eigen::Vector2d AtUnitDepth(const CameraModel& camera, const Eigen::Vector2d& pixel) {
  return {(pixel.x() - camera.cx) / camera.fx, (pixel.y() - camera.cy) / camera.fy};
}

Eigen::Vector2d PixelOf(const CameraModel& camera, const Eigen::Vector2d& p) {
  return {camera.cx + camera.fx * p.x(), camera.cy + camera.fy * p.y()};
}

/// Calls `visit` with points of the image's four sides: which side (0 left, 1 right, 2 top, 3
/// bottom), and where.
template <class Visit>
void AlongTheBorder(const CameraModel& image, Visit visit) {
  constexpr int kSteps = 64;
  const double w = image.width_px, h = image.height_px;
  for (int i = 0; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    visit(0, Eigen::Vector2d(0.0, share * h));
    visit(1, Eigen::Vector2d(w, share * h));
    visit(2, Eigen::Vector2d(share * w, 0.0));
    visit(3, Eigen::Vector2d(share * w, h));
  }
}

}  // namespace

Eigen::Vector2d LensDistortion::Applied(const Eigen::Vector2d& pinhole) const {
  const double x = pinhole.x(), y = pinhole.y(), r2 = pinhole.squaredNorm();
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  return {x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
          y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y};
}

std::optional<Eigen::Vector2d> LensDistortion::Removed(const Eigen::Vector2d& image) const {
  if (is_none()) return image;
  // From the axis outwards along the ray, so that Newton's steps stay on the side that the axis is
  // on: beyond a fold there are further solutions, which no light takes.
  constexpr int kStages = 4, kSteps = 8;
  Eigen::Vector2d p = Eigen::Vector2d::Zero();
  for (int stage = 1; stage <= kStages; ++stage) {
    const Eigen::Vector2d goal = image * stage / kStages;
    for (int step = 0; step < kSteps; ++step) {
      const Eigen::Matrix2d J = Derivative(*this, p);
      if (J.determinant() < 0.02 || J.trace() < 0.0) return std::nullopt;
      const Eigen::Vector2d move = J.inverse() * (goal - Applied(p));
      p += move;
      if (!(p.squaredNorm() < kFarthestView * kFarthestView)) return std::nullopt;
      if (move.squaredNorm() < 1e-24) break;
    }
  }
  return (Applied(p) - image).squaredNorm() < 1e-16 ? std::optional(p) : std::nullopt;
}

bool LensModel::IsOneToOne(const CameraModel& image, const LensDistortion& distortion) {
  constexpr int kSteps = 32;
  constexpr double kLeastGrowth = 0.1;  // of an area: well off a fold, so that pixels between are
  constexpr double kMostPixels = 1e5;   // from the axis
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const Eigen::Vector2d pixel(image.width_px * (i * 1.0 / kSteps),
                                  image.height_px * (j * 1.0 / kSteps));
      const auto p = distortion.Removed(AtUnitDepth(image, pixel));
      if (!p || Derivative(distortion, *p).determinant() < kLeastGrowth) return false;
      if (!(PixelOf(image, *p).lpNorm<Eigen::Infinity>() < kMostPixels)) return false;
    }
  }
  return true;
}

LensModel::LensModel(const CameraModel& image, const LensDistortion& distortion)
    : image_(image), distortion_(distortion), rectified_(image), enclosing_(image) {
  if (is_pinhole()) return;
  LIMPET_REQUIRE(IsOneToOne(image, distortion), "a lens that folds its image");
  constexpr double kFar = std::numeric_limits<double>::max();
  std::array<double, 4> inner{-kFar, kFar, -kFar, kFar}, outer{kFar, -kFar, kFar, -kFar};
  AlongTheBorder(image, [&](int side, const Eigen::Vector2d& pixel) {
    const Eigen::Vector2d p = ToPinhole(image_, pixel);
    const auto s = static_cast<std::size_t>(side);
    const double at = side < 2 ? p.x() : p.y();
    inner[s] = side % 2 == 0 ? std::max(inner[s], at) : std::min(inner[s], at);
    outer[s] = side % 2 == 0 ? std::min(outer[s], at) : std::max(outer[s], at);
  });
  rectified_ = Framed({std::ceil(inner[0]), std::floor(inner[1])},
                      {std::ceil(inner[2]), std::floor(inner[3])});
  enclosing_ = Framed({std::floor(outer[0]), std::ceil(outer[1])},
                      {std::floor(outer[2]), std::ceil(outer[3])});
}

CameraModel LensModel::Framed(const Interval& u_px, const Interval& v_px) const {
  CameraModel camera = image_;
  constexpr double kMostPixels = 1e5;
  camera.width_px = static_cast<int>(std::clamp(u_px.high - u_px.low, 1.0, kMostPixels));
  camera.height_px = static_cast<int>(std::clamp(v_px.high - v_px.low, 1.0, kMostPixels));
  camera.cx -= u_px.low;
  camera.cy -= v_px.low;
  return camera;
}

Eigen::Vector2d LensModel::ToPinhole(const CameraModel& pinhole,
                                     const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d inside(std::clamp<double>(pixel.x(), 0.0, image_.width_px),
                               std::clamp<double>(pixel.y(), 0.0, image_.height_px));
  const std::optional<Eigen::Vector2d> p = distortion_.Removed(AtUnitDepth(image_, inside));
  LIMPET_REQUIRE(p.has_value(), "a pixel inside the image");
  return PixelOf(pinhole, *p);
}

Eigen::Vector2d LensModel::FromPinhole(const CameraModel& pinhole,
                                       const Eigen::Vector2d& pixel) const {
  return PixelOf(image_, distortion_.Applied(AtUnitDepth(pinhole, pixel)));
}

}  // namespace limpet
