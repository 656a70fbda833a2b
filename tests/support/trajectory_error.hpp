// SPDX-License-Identifier: MIT
// Errors of a trajectory and of landmarks against the truth, absolute and aligned.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "estimation/replay/replay.hpp"

namespace limpet {

struct TrueLandmark {
  int id = 0;
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
};

/// Truth of a recorded stream.
struct StreamTruth {
  std::vector<double> t;
  std::vector<Eigen::Vector3d> p;
  std::vector<TrueLandmark> landmarks;
  [[nodiscard]] Eigen::Vector3d At(double time) const;
};
[[nodiscard]] StreamTruth LoadTruth(const std::filesystem::path& folder);

/// Horizontal shift, shift in z and turn that bring an estimate onto the truth best.
struct Alignment {
  double turn = 0.0;
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  [[nodiscard]] Eigen::Vector3d Apply(const Eigen::Vector3d& p) const;
};
struct TrajectoryError {
  double absolute = 0.0, aligned = 0.0, aligned_horizontal = 0.0;  ///< RMSE [m]
  Alignment alignment;
};
[[nodiscard]] TrajectoryError ErrorOf(const std::vector<SmoothedPose>& poses,
                                      const StreamTruth& truth);

/// Each estimated landmark against the nearest true one after alignment.
struct LandmarkErrors {
  double aligned_max = 0.0, aligned_mean = 0.0, absolute_max = 0.0;
  int duplicates = 0, false_ones = 0;
  std::vector<int> missed;
};
[[nodiscard]] LandmarkErrors ErrorsOf(const std::vector<LandmarkEstimate>& landmarks,
                                      const Alignment& alignment, const StreamTruth& truth);

}  // namespace limpet
