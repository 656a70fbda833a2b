// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <Eigen/Core>

#include "limpet/vehicle/vehicle_params.hpp"

namespace limpet {

/// A rigid body as contact sees it.
struct ContactState {
  Eigen::Vector3d p_WB;
  Eigen::Matrix3d R_WB;
  Eigen::Vector3d v_WB_W;
  Eigen::Vector3d omega_B;
};

/// max(0, depth) rounded over `width`: width ln(1 + exp(depth / width)) [m].
[[nodiscard]] double SoftPenetration(double depth, double width);

/// Wrench of the seabed on the skids in body axes. Normal force (taken as vertical: slopes are
/// gentle) of a soft spring with Hunt-Crossley damping, and friction that is viscous near rest.
/// Smooth everywhere, and never pulls: a hard penalty makes the solver chatter.
[[nodiscard]] Wrench SeabedContactWrench(
    const ContactParams& params, const std::function<double(const Eigen::Vector2d& p_W)>& seabed,
    const ContactState& state);

}  // namespace limpet
