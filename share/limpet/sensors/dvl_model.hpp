// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"
#include "limpet/sensors/sound_scene.hpp"
#include "limpet/topics/sensors.hpp"
#include "limpet/topics/simulation.hpp"
#include "limpet/vehicle/sensor_sheets.hpp"

namespace limpet {

/// Doppler velocity log: bottom-track velocity at its lever arm, in its own frame, with scale,
/// misalignment, bias and noise, and four slant ranges to seabed or object. Fails as they do:
/// dropouts of seconds, and gross velocity errors that are still marked valid.
class DvlModel {
 public:
  struct Params {
    DvlSheet sheet;
    double dropout_per_min = 0.0;
    double dropout_shortest_s = 1.0, dropout_longest_s = 10.0;
    double outlier_share = 0.0;
    double outlier_sigma_mps = 0.5;
  };
  DvlModel(const Params& params, SoundScene scene, Random random);
  [[nodiscard]] std::optional<DvlSample> Sample(const SimTruth& truth, Seconds now);

 private:
  using Ranges = std::array<std::optional<double>, 4>;
  [[nodiscard]] bool IsInDropout(Seconds now);
  [[nodiscard]] Ranges MeasureRanges(const Pose& X_WB);
  /// Height above the seabed that the beams together see, or nothing with fewer than three.
  [[nodiscard]] std::optional<double> Altitude(const Ranges& ranges, const Pose& X_WB) const;
  [[nodiscard]] Eigen::Vector3d MeasureVelocity(const SimTruth& truth);

  Params params_;
  SoundScene scene_;
  Random random_;
  Random faults_;  // a stream of its own: faults leave the noise of other samples as it was
  std::array<Eigen::Vector3d, 4> beams_B_;
  Eigen::Matrix3d R_DB_;  ///< into its own frame
  Eigen::Matrix3d distortion_;
  Eigen::Vector3d bias_;
  std::optional<Seconds> next_dropout_;
  Seconds dropout_until_{0.0};
};

}  // namespace limpet
