// SPDX-License-Identifier: MIT
#include "estimation/mapping/object_look.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "limpet/core/probability.hpp"

namespace limpet {
namespace {

constexpr int kFewestCells = 6;
constexpr double kLeastConfidence = 0.55;
constexpr double kMostConfidence = 0.97;
constexpr double kSmallestRadius = 0.05;
constexpr double kLargestRadius = 10.0;  ///< twice the largest that a mission may look for

/// Distance along a unit ray from `origin` to its first meeting with a sphere.
std::optional<double> FirstMeeting(const Eigen::Vector3d& origin, const Eigen::Vector3d& ray,
                                   const Eigen::Vector3d& centre, double radius) {
  const Eigen::Vector3d to_centre = centre - origin;
  const double along = ray.dot(to_centre);
  const double half_chord_squared = radius * radius - (to_centre.squaredNorm() - along * along);
  if (half_chord_squared < 0.0 || along <= 0.0) {
    return std::nullopt;
  }
  return along - std::sqrt(half_chord_squared);
}

/// Centre and size of one axis of a box.
struct Side {
  double centre, size;
};

/// The side with its cut end put where the object's half size has it.
Side Mended(const Side& side, const BoxExtent& extent, double half) {
  if (!extent.is_cut()) {
    return side;
  }
  if (!extent.is_half_cut()) {
    return {side.centre, std::max(side.size, 2.0 * half)};
  }
  const double mended = std::max(half, 0.5 * side.size);
  return {extent.CentreOf(mended), 2.0 * mended};
}

bool IsInImage(const CameraModel& camera, double u, double v) {
  return u >= 0.0 && u <= camera.width_px && v >= 0.0 && v <= camera.height_px;
}

}  // namespace

Box WholeBox(const Box& box, const Eigen::Vector2d& half_px, const CameraModel& camera) {
  const BoxExtent across = ExtentAcross(box, camera), along = ExtentAlong(box, camera);
  const bool is_corner = across.is_cut() && along.is_cut();
  const double aspect = camera.fx / camera.fy;
  const Side whole_u =
      Mended({box.u, box.w}, across, is_corner ? half_px.x() : 0.5 * box.h * aspect);
  const Side whole_v =
      Mended({box.v, box.h}, along, is_corner ? half_px.y() : 0.5 * box.w / aspect);
  Box whole = box;
  whole.u = whole_u.centre, whole.w = whole_u.size;
  whole.v = whole_v.centre, whole.h = whole_v.size;
  return whole;
}

double ObjectProbability(const BoxPixel& pixel, double confidence) {
  const auto& [r_px, s_px] = pixel;
  const double p_c = std::clamp(confidence, kLeastConfidence, kMostConfidence);
  return 0.5 + (p_c - 0.5) * std::exp(-0.5 * (r_px * r_px) / (s_px * s_px));
}

double RadiusFromBox(const ObjectLook& look, const CameraModel& camera) {
  const double depth = camera.InCamera(look.X_WB, look.object_W).z();
  const double radius = 0.25 * depth * (look.box.w / camera.fx + look.box.h / camera.fy);
  return std::clamp(radius, kSmallestRadius, kLargestRadius);
}

std::vector<VoxelEvidence> NearSurface(const ObjectLook& look, const CameraModel& camera,
                                       const SampledSphere& sphere) {
  const Box& box = look.box;
  const Eigen::Matrix3d R_WB = RotationOf(look.X_WB);
  const Eigen::Matrix3d R_WC = R_WB * camera.R_BC;
  const Eigen::Vector3d origin = look.X_WB.p_WB + R_WB * camera.p_BC;
  const double range = (look.object_W - origin).norm();
  const Eigen::Vector3d centre = origin + range * (R_WC * camera.RayOf({box.u, box.v}));
  const double half_px = std::max(0.25 * (box.w + box.h), 1.0);
  // More cells than the box has pixels would see no more.
  const int most = std::max(kFewestCells, static_cast<int>(std::max(box.w, box.h)));
  const int cells = std::clamp(static_cast<int>(std::ceil(2.0 * sphere.radius / sphere.spacing)),
                               kFewestCells, most);
  std::vector<VoxelEvidence> evidence;
  for (int i = 0; i < cells * cells; ++i) {
    const double du = ((i % cells + 0.5) / cells - 0.5) * box.w;
    const double dv = ((i / cells + 0.5) / cells - 0.5) * box.h;
    if (!IsInImage(camera, box.u + du, box.v + dv)) continue;
    const Eigen::Vector3d ray = R_WC * camera.RayOf({box.u + du, box.v + dv});
    if (const std::optional<double> distance = FirstMeeting(origin, ray, centre, sphere.radius)) {
      const double p = ObjectProbability({std::hypot(du, dv), half_px}, box.confidence);
      evidence.push_back({origin + *distance * ray, LogOddsOf(p)});
    }
  }
  return evidence;
}

std::optional<Eigen::Vector3d> SphereCentre(const std::vector<Eigen::Vector3d>& points_W,
                                            double radius) {
  if (points_W.size() < 4) {
    return std::nullopt;
  }
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points_W) {
    mean += point / static_cast<double>(points_W.size());
  }
  // Seen from above, the surface lies over its centre; NED counts downwards.
  Eigen::Vector3d centre = mean + Eigen::Vector3d(0.0, 0.0, 0.5 * radius);
  for (int iteration = 0; iteration < 20; ++iteration) {
    Eigen::Matrix3d information = 1e-6 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d vector = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : points_W) {
      const Eigen::Vector3d outward = point - centre;
      const double distance = std::max(outward.norm(), 1e-9);
      const Eigen::Vector3d J = -outward / distance;
      information += J * J.transpose();
      vector += J * (radius - distance);
    }
    const Eigen::Vector3d step = information.ldlt().solve(vector);
    centre += step;
    if (step.norm() < 1e-4) break;
  }
  const bool is_near = (centre - mean).norm() < 2.0 * radius;
  return is_near ? std::optional<Eigen::Vector3d>(centre) : std::nullopt;
}

}  // namespace limpet
