// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"
#include "limpet/sensors/gauss_markov.hpp"
#include "limpet/topics/sensors.hpp"
#include "limpet/topics/simulation.hpp"

namespace limpet {

/// GPS (u-blox 7 class) with its antenna on a mast: no fix under water; an error that is mostly
/// common to the fixes of two minutes, so that many fixes are worth little more than one.
class GpsModel {
 public:
  struct Params {
    double sigma_m = 0.4;  ///< of each horizontal axis
    Seconds correlation{120.0};
    double noise_m = 0.05;  ///< white, on top
    Eigen::Vector3d antenna_B{0.0, 0.0, -0.25};
  };
  GpsModel(const Params& params, Random random)
      : params_(params),
        random_(random),
        north_(params.sigma_m, params.correlation),
        east_(params.sigma_m, params.correlation) {}

  [[nodiscard]] std::optional<GpsFix> Sample(const SimTruth& truth, Seconds now) {
    const Eigen::Vector3d antenna_W =
        truth.pose().p_WB + RotationOf(truth.pose()) * params_.antenna_B;
    if (antenna_W.z() >= 0.0) return std::nullopt;
    GpsFix fix{.sd = params_.sigma_m};
    fix.north = antenna_W.x() + north_.Sample(now, random_) + random_.Normal(params_.noise_m);
    fix.east = antenna_W.y() + east_.Sample(now, random_) + random_.Normal(params_.noise_m);
    return fix;
  }

 private:
  Params params_;
  Random random_;
  GaussMarkov north_, east_;
};

}  // namespace limpet
