// SPDX-License-Identifier: MIT
#include "estimation/association/box_gate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include "estimation/smoothing/camera_point.hpp"
#include "estimation/smoothing/sphere_edge.hpp"

namespace limpet {
namespace {

constexpr double kNearestPoint = 0.3;  // [m]
constexpr double kSizeSigmas = 3.0;    // of the range from size: boxes that overlap agree in it
constexpr double kOverlapShare = 0.6;  // of the gate: most that boxes which overlap are off
// 1-sigma of a cut axis's one edge: pixels, and a share of the expected size.
constexpr double kEdgeFloor = 4.0, kEdgeShare = 0.15;

struct AxisOffset {
  double offset = 0.0;  ///< of the box from where the sphere should appear [px]
  double size = 0.0;    ///< of the expected box [px]
};

/// Where a sphere's edge appears that the border leaves, the end of its image without a border if
/// it is too near to tell.
double ShownEdge(const CameraModel& camera, const Eigen::Vector3d& p_C, double radius, BoxEnd end,
                 double of_whole) {
  const std::optional<SphereEdge> edge = EdgeOfSphere(camera, p_C, radius, end);
  return edge ? edge->px : of_whole;
}

/// Offset of a box, whose extent along that axis is given, from the sphere it may show; nothing if
/// both edges are cut, which tells nothing.
std::optional<AxisOffset> OffsetAlong(const CameraModel& camera, const Eigen::Vector3d& p_C,
                                      double radius, const ReadDetection& seen, int axis) {
  const BoxExtent box = axis == 0 ? ExtentAcross(seen.box, camera) : ExtentAlong(seen.box, camera);
  if (box.is_low_cut && box.is_high_cut) return std::nullopt;
  const SphereExtent expected = ExtentOfSphere(camera, p_C, radius, axis);
  const double size = expected.high - expected.low;
  if (!box.is_cut()) return AxisOffset{seen.reading.centre_px(axis) - expected.centre, size};
  const BoxEnd end{.axis = axis, .side = box.is_low_cut ? BoxSide::kHigh : BoxSide::kLow};
  const double of_whole = box.is_low_cut ? expected.high : expected.low;
  return AxisOffset{box.shown_end() - ShownEdge(camera, p_C, radius, end, of_whole), size};
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

/// Distance of an object from the camera, with 1-sigma [m].
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
  const BoxReading& reading = seen.reading;
  const CameraPoint point = CameraPointOf(camera_, x, object.p_W);
  const Eigen::Vector3d& p = point.p_C;
  if (p.z() < kNearestPoint) {
    return std::nullopt;
  }
  const auto along_u = OffsetAlong(camera_, p, object.radius, seen, 0);
  const auto along_v = OffsetAlong(camera_, p, object.radius, seen, 1);
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
  const double class_share = object.color == seen.box.color ? 1.0 - confused : confused;
  const double normaliser =
      std::log(4.0 * std::numbers::pi * std::numbers::pi * innovation.determinant());
  return BoxMatch{.cost = distance2 + normaliser - 2.0 * std::log(class_share),
                  .new_cost = new_cost,
                  .distance2 = distance2,
                  .spread_px = WorstSigma(S)};
}

}  // namespace limpet
