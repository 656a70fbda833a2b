// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "estimation/smoothing/factors/camera_factor.hpp"
#include "estimation/smoothing/sphere_edge.hpp"
#include "limpet/core/box_extent.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// A box along an axis that the image's border cuts, per end:
///   r = (end of what the image shows of a sphere of known radius - that of the box) / sigma [px];
/// zero at an end that the border cuts, if the sphere goes on there. Near the camera plane, or
/// inside the sphere, the residual of an end that shows is large and its derivative zero.
class CutAxisFactor : public CameraFactor<CutAxisFactor, 2> {
 public:
  struct Measurement {
    int axis = 0;  ///< along u (0) or v (1)
    BoxExtent box{};
    double sigma_px = 1.0;
  };
  /// `camera` must outlive the factor.
  CutAxisFactor(const CameraModel& camera, Meters radius, const Measurement& seen)
      : CameraFactor(camera), radius_(radius.value()), seen_(seen) {}

  /// Residual of a point in the camera's frame, with the derivative by it.
  [[nodiscard]] Residual InCamera(const Eigen::Vector3d& p_C, BorderJacobian& J_C) const {
    Residual J_size;
    return InCamera(p_C, 0.0, J_C, J_size);
  }
  /// Residual for a sphere exp(log_size) times as large, also with the derivative by that.
  [[nodiscard]] Residual InCamera(const Eigen::Vector3d& p_C, double log_size, BorderJacobian& J_C,
                                  Residual& J_size) const {
    J_C.setZero();
    J_size.setZero();
    Residual r = Residual::Zero();
    const double radius = radius_ * std::exp(log_size);
    for (const BoxSide side : {BoxSide::kLow, BoxSide::kHigh}) {
      const bool is_low = side == BoxSide::kLow;
      const int row = is_low ? 0 : 1;
      const bool is_cut = is_low ? seen_.box.is_low_cut : seen_.box.is_high_cut;
      const auto edge = EdgeOfSphere(camera(), p_C, radius, {.axis = seen_.axis, .side = side});
      if (!edge) {
        r(row) = is_cut ? 0.0 : kLost_px / seen_.sigma_px;
        continue;
      }
      const double off_px = edge->px - (is_low ? seen_.box.low : seen_.box.high);
      const bool goes_on = is_cut && (is_low ? off_px <= 0.0 : off_px >= 0.0);
      if (goes_on) continue;
      r(row) = off_px / seen_.sigma_px;
      J_C.row(row) = edge->by_p_C / seen_.sigma_px;
      J_size(row) = edge->by_log_radius / seen_.sigma_px;
    }
    return r;
  }

 private:
  double radius_;
  Measurement seen_;
};

}  // namespace limpet
