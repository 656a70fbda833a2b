// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"
#include "limpet/simulation/gauss_markov.hpp"
#include "limpet/simulation/gps_error.hpp"
#include "limpet/topics/sensors.hpp"
#include "limpet/topics/simulation.hpp"
#include "limpet/vehicle/sensor_sheets.hpp"

namespace limpet {

/// GPS with its antenna on a mast: no fix under water; an error that is mostly
/// common to the fixes of two minutes, so that many fixes are worth little more than one.
class GpsModel {
 public:
  struct Params {
    GpsSheet sheet;                        ///< what the receiver says of itself with each fix
    std::optional<double> true_sigma_m{};  ///< of each horizontal axis, unless it is the sheet's
    Eigen::Vector3d antenna_B{0.0, 0.0, -0.25};
    GpsErrorParams error{};
  };
  GpsModel(const Params& params, Random random, Random errors = Random(0))
      : params_(params),
        random_(random),
        error_(params.error, errors),
        north_(params.true_sigma_m.value_or(params.sheet.sigma_m), params.sheet.correlation),
        east_(params.true_sigma_m.value_or(params.sheet.sigma_m), params.sheet.correlation) {}

  [[nodiscard]] std::optional<GpsFix> Sample(const SimTruth& truth, Seconds now) {
    const Eigen::Vector3d antenna_W =
        truth.pose().p_WB + RotationOf(truth.pose()) * params_.antenna_B;
    if (antenna_W.z() >= 0.0) return std::nullopt;
    GpsFix fix{.sd = params_.sheet.sigma_m};
    fix.north = antenna_W.x() + north_.Sample(now, random_) + random_.Normal(params_.sheet.noise_m);
    fix.east = antenna_W.y() + east_.Sample(now, random_) + random_.Normal(params_.sheet.noise_m);
    const Eigen::Vector2d off_W = error_.At(now);
    fix.north += off_W.x(), fix.east += off_W.y();
    return fix;
  }

 private:
  Params params_;
  Random random_;
  GpsError error_;
  GaussMarkov north_, east_;
};

}  // namespace limpet
