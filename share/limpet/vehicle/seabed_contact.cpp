// SPDX-License-Identifier: MIT
#include "limpet/vehicle/seabed_contact.hpp"

#include <cmath>

#include <Eigen/Geometry>

namespace limpet {
namespace {

using Eigen::Vector3d;

/// Beyond this many widths the rounding is below a double's resolution.
constexpr double kFarInWidths = 40.0;

/// Force of the seabed at one skid, in W.
Vector3d SkidForce(const ContactParams& params, double penetration, const Vector3d& v_W) {
  const double soft = SoftPenetration(penetration, params.softness_m);
  // The damping factor 1 + c v falls below zero for a fast lift-off: rounded off, as penetration.
  const double damping = SoftPenetration(1.0 + params.damping_s_per_m * v_W.z(), 0.1);
  const double normal = params.stiffness_n_per_m * soft * damping;
  const double sliding = std::sqrt(v_W.head<2>().squaredNorm() +
                                   params.friction_speed_mps * params.friction_speed_mps);
  const double drag = params.friction * normal / sliding;
  return {-drag * v_W.x(), -drag * v_W.y(), -normal};
}

}  // namespace

double SoftPenetration(double depth, double width) {
  const double x = depth / width;
  if (x > kFarInWidths) return depth;
  return width * std::log1p(std::exp(x));
}

Wrench SeabedContactWrench(const ContactParams& params,
                           const std::function<double(const Eigen::Vector2d& p_W)>& seabed,
                           const ContactState& state) {
  Wrench total = Wrench::Zero();
  for (const Vector3d& skid_B : params.skids_B) {
    const Vector3d skid_W = state.p_WB + state.R_WB * skid_B;
    const double penetration = skid_W.z() - seabed(skid_W.head<2>());
    if (penetration < -kFarInWidths * params.softness_m) continue;
    const Vector3d v_W = state.v_WB_W + state.R_WB * state.omega_B.cross(skid_B);
    const Vector3d force_B = state.R_WB.transpose() * SkidForce(params, penetration, v_W);
    total.head<3>() += force_B;
    total.tail<3>() += skid_B.cross(force_B);
  }
  return total;
}

}  // namespace limpet
