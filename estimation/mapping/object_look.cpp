// SPDX-License-Identifier: MIT
#include "estimation/mapping/object_look.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace limpet {
namespace {

constexpr int kFewestCells = 6;
constexpr int kMostCells = 40;
constexpr double kLeastConfidence = 0.55;
constexpr double kMostConfidence = 0.97;
constexpr double kSmallestRadius = 0.05;
constexpr double kLargestRadius = 3.0;

/// Direction of a pixel's ray in W, unit.
Eigen::Vector3d RayOf(const CameraGeometry& camera, const Eigen::Matrix3d& R_WC, double u,
                      double v) {
  return R_WC *
         Eigen::Vector3d((u - camera.cx()) / camera.fx(), (v - camera.cy()) / camera.fy(), 1.0)
             .normalized();
}

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

}  // namespace

double ObjectProbability(double r_px, double s_px, double confidence) {
  const double p_c = std::clamp(confidence, kLeastConfidence, kMostConfidence);
  return 0.5 + (p_c - 0.5) * std::exp(-0.5 * (r_px * r_px) / (s_px * s_px));
}

double RadiusFromBox(const ObjectLook& look, const CameraGeometry& camera) {
  const double depth = camera.InCamera(look.X_WB, look.object_W).z();
  const double radius = 0.25 * depth * (look.box.w / camera.fx() + look.box.h / camera.fy());
  return std::clamp(radius, kSmallestRadius, kLargestRadius);
}

std::vector<VoxelEvidence> NearSurface(const ObjectLook& look, const CameraGeometry& camera,
                                       double radius, double spacing) {
  const SightedDetection& box = look.box;
  const Eigen::Matrix3d R_WB = RotationOf(look.X_WB);
  const Eigen::Matrix3d R_WC = R_WB * CameraGeometry::R_BC();
  const Eigen::Vector3d origin = look.X_WB.p_WB + R_WB * camera.p_BC;
  const double range = (look.object_W - origin).norm();
  const Eigen::Vector3d centre = origin + range * RayOf(camera, R_WC, box.u, box.v);
  const double half_px = std::max(0.25 * (box.w + box.h), 1.0);
  const int cells =
      std::clamp(static_cast<int>(std::ceil(2.0 * radius / spacing)), kFewestCells, kMostCells);
  std::vector<VoxelEvidence> evidence;
  for (int i = 0; i < cells * cells; ++i) {
    const double du = ((i % cells + 0.5) / cells - 0.5) * box.w;
    const double dv = ((i / cells + 0.5) / cells - 0.5) * box.h;
    const Eigen::Vector3d ray = RayOf(camera, R_WC, box.u + du, box.v + dv);
    if (const std::optional<double> distance = FirstMeeting(origin, ray, centre, radius)) {
      const double p = ObjectProbability(std::hypot(du, dv), half_px, box.confidence);
      evidence.push_back({origin + *distance * ray, std::log(p / (1.0 - p))});
    }
  }
  return evidence;
}

std::optional<Eigen::Vector3d> SphereCentre(const std::vector<Eigen::Vector3d>& points,
                                            double radius) {
  if (points.size() < 4) {
    return std::nullopt;
  }
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) {
    mean += point / static_cast<double>(points.size());
  }
  // Seen from above, the surface lies over its centre; NED counts downwards.
  Eigen::Vector3d centre = mean + Eigen::Vector3d(0.0, 0.0, 0.5 * radius);
  for (int iteration = 0; iteration < 20; ++iteration) {
    Eigen::Matrix3d information = 1e-6 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d vector = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : points) {
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
