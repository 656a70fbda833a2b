// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "limpet/core/random.hpp"
#include "limpet/core/units.hpp"
#include "limpet/sensors/sound_scene.hpp"
#include "limpet/simulation/beam_error.hpp"
#include "limpet/simulation/false_velocity.hpp"
#include "limpet/simulation/random_intervals.hpp"
#include "limpet/simulation/simulated_errors.hpp"
#include "limpet/topics/sensors.hpp"
#include "limpet/topics/simulation.hpp"
#include "limpet/vehicle/sensor_sheets.hpp"

namespace limpet {

/// Doppler velocity log: bottom-track velocity at its lever arm, in its own frame, with scale,
/// misalignment, bias and noise, and four slant ranges to seabed or object. Fails as they do:
/// dropouts of seconds, gross velocity errors that are still marked valid, and what the scenario
/// adds.
class DvlModel {
 public:
  struct Params {
    DvlSheet sheet;
    double dropout_per_min = 0.0;
    double dropout_shortest_s = 1.0, dropout_longest_s = 10.0;
    double outlier_share = 0.0;
    double outlier_sigma_mps = 0.5;
    SimulatedErrors::Dvl error{};
  };
  DvlModel(const Params& params, SoundScene scene, Random random, Random errors = Random(0));
  [[nodiscard]] std::optional<DvlSample> Sample(const SimTruth& truth, Seconds now);

 private:
  using Ranges = std::array<std::optional<double>, 4>;
  [[nodiscard]] Ranges MeasureRanges(const Pose& X_WB);
  /// Height above the seabed that the beams together see, or nothing with fewer than three.
  [[nodiscard]] std::optional<double> Altitude(const Ranges& ranges, const Pose& X_WB) const;
  [[nodiscard]] Eigen::Vector3d MeasureVelocity(const SimTruth& truth);
  /// Slopes of the seabed along the beams; level where a beam meets nothing.
  [[nodiscard]] BeamError::Slopes SlopesAt(const Pose& X_WB, const Ranges& ranges) const;

  Params params_;
  DvlSheet true_;  ///< what it is; it says of itself what the sheet does
  SoundScene scene_;
  Random random_;
  Eigen::Vector3d p_BD_;
  Random faults_;  // a stream of its own: faults leave the noise of other samples as it was
  std::array<Eigen::Vector3d, 4> beams_B_;
  Eigen::Matrix3d R_DB_;  ///< into its own frame
  Eigen::Matrix3d distortion_;
  Eigen::Vector3d bias_;
  RandomIntervals dropouts_;
  BeamError beam_error_;
  FalseVelocity bursts_;
};

}  // namespace limpet
