// SPDX-License-Identifier: MIT
#include "limpet/imaging/solid_image.hpp"

#include <cmath>

namespace limpet {
namespace {

/// The greatest x / z (or y / z) over the form: where the support function of the plane's normal
/// (1, 0, -t) vanishes. It falls with t, since z > 0 all over the form.
class EdgeFinder {
 public:
  EdgeFinder(const Solid& solid, const Eigen::Matrix3d& R_SC, const Eigen::Vector3d& p_C)
      : solid_(solid), R_SC_(R_SC), p_C_(p_C) {}

  [[nodiscard]] double Find(const Eigen::Vector3d& axis_C) const {
    const double bound = solid_.BoundingRadius();
    const double middle = axis_C.dot(p_C_) / p_C_.z();
    double low = middle - 1e-9;
    double high = middle + 1e-9;
    for (double step = bound / p_C_.z(); Reaches(axis_C, high); step *= 2.0)
      high += step;
    constexpr int kHalvings = 40;
    for (int i = 0; i < kHalvings; ++i) {
      const double t = 0.5 * (low + high);
      (Reaches(axis_C, t) ? low : high) = t;
    }
    return 0.5 * (low + high);
  }

 private:
  [[nodiscard]] bool Reaches(const Eigen::Vector3d& axis_C, double t) const {
    const Eigen::Vector3d normal_C = axis_C - t * Eigen::Vector3d::UnitZ();
    return normal_C.dot(p_C_) + solid_.ReachAlong(R_SC_ * normal_C) > 0.0;
  }
  const Solid& solid_;
  const Eigen::Matrix3d& R_SC_;
  const Eigen::Vector3d& p_C_;
};

}  // namespace

std::optional<PixelRect> OutlineOf(const CameraModel& camera, const Pose& X_WB,
                                   const Solid& solid) {
  const Eigen::Vector3d p_C = camera.InCamera(X_WB, solid.p_W);
  const Eigen::Matrix3d R_WC = RotationOf(X_WB) * camera.R_BC;
  const Eigen::Matrix3d R_SC = solid.R_WS.transpose() * R_WC;
  constexpr double kNearest = 0.02;  // [m]
  if (p_C.z() - solid.ReachAlong(-R_SC.col(2)) < kNearest) return std::nullopt;
  const EdgeFinder edges(solid, R_SC, p_C);
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  return PixelRect{.left = camera.cx - camera.fx * edges.Find(-x),
                   .top = camera.cy - camera.fy * edges.Find(-y),
                   .right = camera.cx + camera.fx * edges.Find(x),
                   .bottom = camera.cy + camera.fy * edges.Find(y)};
}

}  // namespace limpet
