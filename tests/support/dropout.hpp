// SPDX-License-Identifier: MIT
// A dropout of the DVL put into any stream, and how right and how sure the estimator was then.
#pragma once

#include <algorithm>
#include <cmath>
#include <variant>

#include <Eigen/Cholesky>

#include "estimation/replay/replay.hpp"
#include "limpet/core/interval.hpp"
#include "tests/support/trajectory_error.hpp"

namespace limpet {

/// The stream with a DVL that has no bottom lock in `span` [s].
inline SensorStream WithoutVelocity(SensorStream stream, const Interval& span) {
  for (StreamRow& row : stream.rows) {
    auto* dvl = std::get_if<DvlRow>(&row);
    if (dvl != nullptr && dvl->t >= span.low && dvl->t < span.high) {
      *dvl = DvlRow{.t = dvl->t, .v_WD_B = {}, .altitude = {}};
    }
  }
  return stream;
}

/// Where the vehicle was taken to be at a time, while the session ran.
struct PlaceError {
  double off = 0.0;    ///< horizontal [m]
  double sigma = 0.0;  ///< that was claimed, of both axes together [m]
  double nees = 0.0;   ///< squared error over covariance: 2 if both agree
};

/// Of the last place told before `t` [s]. REQUIRES: one was.
inline PlaceError PlaceErrorAt(double t, const ReplayResult& result, const StreamTruth& truth) {
  const auto next = std::ranges::lower_bound(result.online, t, {}, &SmoothedPose::t);
  const auto i = static_cast<std::size_t>(
      std::max<std::ptrdiff_t>(std::distance(result.online.begin(), next) - 1, 0));
  const SmoothedPose& told = result.online[i];
  const Eigen::Vector2d off = (told.X_WB.p_WB - truth.At(told.t)).head<2>();
  const Eigen::Matrix2d covariance = result.online_covariance_W[i].topLeftCorner<2, 2>();
  return {.off = off.norm(),
          .sigma = std::sqrt(covariance.trace()),
          .nees = off.dot(covariance.llt().solve(off))};
}

}  // namespace limpet
