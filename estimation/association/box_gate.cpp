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
constexpr double kSizeSigmas = 3.0;    // of the range from size: boxes that overlap agree in it
constexpr double kOverlapShare = 0.6;  // of the gate: most that boxes which overlap are off
// 1-sigma of a cut axis's one edge: pixels, and a share of the expected size.
constexpr double kEdgeFloor = 4.0, kEdgeShare = 0.15;

/// One axis of an image: focal length and principal point [px].
struct ImageAxis {
  double f, c;
};
/// A sphere in the plane of that axis and the optical one [m].
struct PlaneSphere {
  double side, depth, radius;
};
/// A box along that axis, and the pixel of the centre of the sphere it shows.
struct ReadExtent {
  BoxExtent box;
  double centre;
};
struct AxisOffset {
  double offset = 0.0;  ///< of the box from where the sphere should appear [px]
  double size = 0.0;    ///< of the expected box [px]
};

/// Nothing if both edges are cut, which tells nothing.
std::optional<AxisOffset> OffsetAlong(const ImageAxis& axis, const PlaneSphere& sphere,
                                      const ReadExtent& seen) {
  const double middle = std::atan2(sphere.side, sphere.depth);
  const double half =
      std::asin(std::min(sphere.radius / std::hypot(sphere.side, sphere.depth), 0.99));
  const double expected_low = axis.c + axis.f * std::tan(std::max(middle - half, -1.5));
  const double expected_high = axis.c + axis.f * std::tan(std::min(middle + half, 1.5));
  const double size = expected_high - expected_low;
  const BoxExtent& box = seen.box;
  if (box.is_low_cut && box.is_high_cut) return std::nullopt;
  if (box.is_low_cut) return AxisOffset{box.high - expected_high, size};
  if (box.is_high_cut) return AxisOffset{box.low - expected_low, size};
  return AxisOffset{seen.centre - (axis.c + axis.f * sphere.side / sphere.depth), size};
}

/// Predicted pixel: covariance, from that of pose and object.
Eigen::Matrix2d PixelCovariance(const CameraPoint& point, const CameraModel& camera,
                                const ExpectedObject& object) {
  const Eigen::Vector3d& p = point.p_C;
  const double k = 1.0 / p.z();
  Eigen::Matrix<double, 2, 3> J_C;
  J_C << camera.fx * k, 0.0, -camera.fx * p.x() * k * k,  //
      0.0, camera.fy * k, -camera.fy * p.y() * k * k;
  Eigen::Matrix<double, 2, 9> J;
  J << J_C * point.J_pose, J_C * point.J_landmark;
  return J * object.covariance * J.transpose() + J_C * object.mount_C * J_C.transpose();
}

/// Standard deviation in the worst direction.
double WorstSigma(const Eigen::Matrix2d& S) {
  const double mean = 0.5 * S.trace(), half = 0.5 * (S(0, 0) - S(1, 1));
  return std::sqrt(mean + std::sqrt(half * half + S(0, 1) * S(0, 1)));
}

/// Of an object from the camera, with 1-sigma [m].
struct ExpectedRange {
  double mean = 0.0, sd = 0.0;
};

/// Innovation of a box: both axes, then the range from size.
class Innovation {
 public:
  Innovation(const Eigen::Matrix2d& S, const BoxGateParams& params) : params_(params), S_(S) {}

  void AddAxis(int axis, const std::optional<AxisOffset>& along, double sigma) {
    if (!along) {
      S_.row(axis).setZero(), S_.col(axis).setZero();
      S_(axis, axis) = 1.0 / (2.0 * std::numbers::pi);
      return;
    }
    const double noise = std::isfinite(sigma) ? sigma : kEdgeFloor + kEdgeShare * along->size;
    const double extra = params_.model_error_px + params_.model_error_share * along->size;
    S_(axis, axis) += noise * noise + extra * extra;
    r_(axis) = along->offset;
    overlaps_ = overlaps_ && std::abs(along->offset) < params_.overlap_share * along->size;
  }
  /// Range of the box's size [m] against the expected one.
  void AddRange(double range, const ExpectedRange& expected) {
    const double off = std::log(range / expected.mean) /
                       std::hypot(params_.range_sigma, expected.sd / expected.mean);
    overlaps_ = overlaps_ && std::abs(off) < kSizeSigmas;
    range_distance2_ = off * off;
  }
  [[nodiscard]] double determinant() const { return S_.determinant(); }
  [[nodiscard]] double Distance2() const {
    double distance2 =
        (S_(1, 1) * r_(0) * r_(0) - 2.0 * S_(0, 1) * r_(0) * r_(1) + S_(0, 0) * r_(1) * r_(1)) /
        determinant();
    distance2 += range_distance2_;
    return overlaps_ ? std::min(distance2, kOverlapShare * params_.chi2_per_gate) : distance2;
  }

 private:
  const BoxGateParams& params_;
  Eigen::Matrix2d S_;
  Eigen::Vector2d r_ = Eigen::Vector2d::Zero();
  double range_distance2_ = 0.0;
  bool overlaps_ = true;
};

/// A distance from a box's size, in the planes that tell it.
struct RangeOfSize {
  double range;  ///< [m]
  Eigen::Vector2d planes;
};

void AddRangeTo(Innovation& innovation, const RangeOfSize& seen, const CameraPoint& point,
                const PoseObjectCovariance& covariance) {
  const Eigen::Vector3d& p = point.p_C;
  const double expected =
      seen.planes.dot(Eigen::Vector2d(std::hypot(p.x(), p.z()), std::hypot(p.y(), p.z())));
  const Eigen::RowVector3d ray_C(0.0, 0.0, 1.0);
  const Eigen::RowVector3d to_object = ray_C * point.J_landmark;
  const double sd = std::sqrt((to_object * covariance.bottomRightCorner<3, 3>()).dot(to_object));
  innovation.AddRange(seen.range, {.mean = expected, .sd = sd});
}

}  // namespace

std::optional<BoxMatch> BoxGate::Match(const ReadDetection& seen, const NavVector& x,
                                       const ExpectedObject& object) const {
  const Box& box = seen.box;
  const BoxReading& reading = seen.reading;
  const CameraPoint point = CameraPointOf(camera_, x, object.p_W);
  const Eigen::Vector3d& p = point.p_C;
  if (p.z() < kNearestPoint) {
    return std::nullopt;
  }
  const auto along_u = OffsetAlong({camera_.fx, camera_.cx}, {p.x(), p.z(), object.radius},
                                   {ExtentAcross(seen.box, camera_), reading.centre_px.x()});
  const auto along_v = OffsetAlong({camera_.fy, camera_.cy}, {p.y(), p.z(), object.radius},
                                   {ExtentAlong(seen.box, camera_), reading.centre_px.y()});
  if (!along_u && !along_v) {
    return std::nullopt;
  }
  const Eigen::Matrix2d S = PixelCovariance(point, camera_, object);
  Innovation innovation(S, params_);
  innovation.AddAxis(0, along_u, reading.sigma_px.x());
  innovation.AddAxis(1, along_v, reading.sigma_px.y());
  if (const auto range = reading.Range(object.radius))
    AddRangeTo(innovation, {*range, reading.size_planes_C}, point, object.covariance);
  const double distance2 = innovation.Distance2();
  if (distance2 > params_.chi2_per_gate) {
    return std::nullopt;
  }
  // Something new may be anywhere along each axis that tells.
  double new_cost = -2.0 * std::log(params_.new_object_share);
  if (along_u) new_cost += 2.0 * std::log(camera_.width_px);
  if (along_v) new_cost += 2.0 * std::log(camera_.height_px);
  const double confused = params_.confused_class_share;
  const double class_share = object.color == box.color ? 1.0 - confused : confused;
  const double normaliser =
      std::log(4.0 * std::numbers::pi * std::numbers::pi * innovation.determinant());
  return BoxMatch{.cost = distance2 + normaliser - 2.0 * std::log(class_share),
                  .new_cost = new_cost,
                  .distance2 = distance2,
                  .spread_px = WorstSigma(S)};
}

}  // namespace limpet
