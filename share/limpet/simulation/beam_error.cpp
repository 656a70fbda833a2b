// SPDX-License-Identifier: MIT
#include "limpet/simulation/beam_error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/QR>

namespace limpet {

BeamError::BeamError(const BeamErrorParams& params, double beam_angle, Random random)
    : params_(params), random_(random) {
  for (int beam = 0; beam < kBeams; ++beam) {
    const double azimuth = (0.25 + 0.5 * beam) * std::numbers::pi;
    directions_.row(beam) << std::sin(beam_angle) * std::cos(azimuth),
        std::sin(beam_angle) * std::sin(azimuth), std::cos(beam_angle);
  }
}

BeamError::Lost BeamError::DrawLost() {
  Lost lost{};
  if (params_.loss_share > 0.0) {
    std::ranges::generate(lost, [this] { return random_.Chance(params_.loss_share); });
  }
  return lost;
}

std::optional<Eigen::Vector3d> BeamError::Velocity(const Eigen::Vector3d& v_D, const Slopes& slopes,
                                                   const Lost& lost) const {
  if (params_.is_off()) return v_D;
  Eigen::Matrix<double, kBeams, 3> along = Eigen::Matrix<double, kBeams, 3>::Zero();
  Eigen::Vector4d speeds = Eigen::Vector4d::Zero();
  for (int beam = 0; beam < kBeams; ++beam) {
    const auto index = static_cast<std::size_t>(beam);
    if (lost[index]) continue;
    along.row(beam) = directions_.row(beam);
    speeds(beam) = directions_.row(beam).dot(v_D) * (1.0 + params_.slope_bias * slopes[index]);
  }
  if (std::ranges::count(lost, false) < 3) return std::nullopt;
  return along.colPivHouseholderQr().solve(speeds);
}

}  // namespace limpet
