// SPDX-License-Identifier: MIT
#include "limpet/sensors/sonar_model.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace limpet {

std::optional<SonarPing> SonarModel::Sample(const SimTruth& truth, Seconds /*now*/) {
  constexpr double kPerMetre = 1000.0;  // said to the millimetre
  const Pose X_WB = truth.pose();
  const Eigen::Matrix3d R_WB = RotationOf(X_WB);
  const Eigen::Vector3d origin_W = X_WB.p_WB + R_WB * sheet_.p_BS;
  SonarPing ping{.first = sheet_.first_bearing(),
                 .step = sheet_.bearing_step(),
                 .reach = sheet_.greatest_range.value(),
                 .ranges = {}};
  ping.ranges.reserve(static_cast<std::size_t>(sheet_.beams));
  for (int beam = 0; beam < sheet_.beams; ++beam) {
    const double bearing = ping.first + beam * ping.step;
    const double noise = random_.Normal(sheet_.range_noise_m);  // drawn for every beam, met or not
    const auto range = scene_.Range(
        origin_W, R_WB * Eigen::Vector3d(std::cos(bearing), std::sin(bearing), 0.0), ping.reach);
    const bool is_heard = range && *range >= sheet_.least_range.value();
    ping.ranges.push_back(
        is_heard ? std::max(0.0, std::round(kPerMetre * (*range + noise)) / kPerMetre) : 0.0);
  }
  return ping;
}

}  // namespace limpet
