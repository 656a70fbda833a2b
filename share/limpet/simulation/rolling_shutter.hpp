// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "limpet/core/body_motion.hpp"
#include "limpet/core/camera_model.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/core/params.hpp"
#include "limpet/core/units.hpp"

namespace limpet {

/// A camera that reads its image row by row. Its stamp is the first row's.
struct RollingShutterParams {
  Seconds readout{0.0};

  template <class V>
  void Describe(V& visit) {
    using namespace literals;
    visit("readout_s", readout, "From the first row of an image to its last: a rolling shutter",
          InRange(0.0_s, 0.5_s));
  }
};

/// Where a point would have to be to show, in an image taken all at once at `X_WB`, where the row
/// by row image shows it. Of a point out of view: the point itself.
[[nodiscard]] Eigen::Vector3d SeenRowByRow(const RollingShutterParams& shutter,
                                           const CameraModel& camera, const Pose& X_WB,
                                           const BodyMotion& motion, const Eigen::Vector3d& p_W);

}  // namespace limpet
