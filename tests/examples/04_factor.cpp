// SPDX-License-Identifier: MIT
// Lesson 4: a measurement becomes a factor, and the smoother believes it as far as it is sure.
#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "estimation/smoothing/arrow_smoother.hpp"
#include "estimation/smoothing/factors/pose_prior_factor.hpp"
#include "limpet/core/units.hpp"

namespace limpet {
namespace {

/// Distance to a transponder at a known place:  r = (|p_WB - p_WT| - measured) / sigma.
/// Next to the transponder the direction is unknown, and the Jacobian is zero there.
class TransponderFactor {
 public:
  static constexpr int kDim = 1;
  using Residual = Eigen::Matrix<double, kDim, 1>;
  using Jacobian = Eigen::Matrix<double, kDim, 6>;

  TransponderFactor(const Eigen::Vector3d& p_WT, Meters measured, Meters sigma)
      : p_WT_(p_WT), measured_(measured.value()), inv_sigma_(1.0 / sigma.value()) {}

  [[nodiscard]] Residual Evaluate(const NavVector& x, Jacobian* J = nullptr) const {
    const Eigen::Vector3d away = x.head<3>() - p_WT_;
    const double distance = away.norm();
    if (J != nullptr) {
      J->setZero();
      J->head<3>() = inv_sigma_ / std::max(distance, 1e-6) * away.transpose();
    }
    return Residual((distance - measured_) * inv_sigma_);
  }

 private:
  Eigen::Vector3d p_WT_;
  double measured_, inv_sigma_;
};

int Run() {
  const NavVector guess = NavVector::Zero();          // x, y, z, yaw, pitch, roll
  const NavVector sigma = NavVector::Constant(1.0);   // a metre, a radian
  const Eigen::Vector3d transponder(10.0, 0.0, 0.0);  // ten metres north
  const TransponderFactor range(transponder, Meters(8.0), Meters(0.1));

  ArrowSmoother smoother;
  const int node = smoother.AddNode(guess, std::nullopt);
  smoother.AddTerm(node, Term::OnPose(PosePriorFactor(guess, sigma)));
  smoother.AddTerm(node, Term::OnPose(range));
  smoother.Converge();
  fmt::print("north {:.2f} m\n", smoother.PoseAt(node)(kNavX));  // the range wins a hundred to one
  return 0;
}

}  // namespace
}  // namespace limpet

int main() { return limpet::Run(); }
