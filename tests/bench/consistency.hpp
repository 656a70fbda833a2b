// SPDX-License-Identifier: MIT
// Whether stated covariances say what errors are (NEES).
#pragma once

#include <algorithm>
#include <vector>

#include <Eigen/Cholesky>

#include "estimation/replay/replay.hpp"
#include "tests/support/trajectory_error.hpp"

namespace limpet {

/// Mean squared error over covariance: 3 if both agree.
struct Consistency {
  double sum = 0.0;
  Eigen::Vector3d per_axis = Eigen::Vector3d::Zero();  ///< 1 each if both agree
  int count = 0;
  void Add(const Eigen::Vector3d& error, const Eigen::Matrix3d& covariance) {
    sum += error.dot(covariance.llt().solve(error));
    per_axis += error.cwiseAbs2().cwiseQuotient(covariance.diagonal());
    ++count;
  }
  [[nodiscard]] Eigen::Vector3d axes() const { return per_axis / std::max(count, 1); }
  [[nodiscard]] double mean() const { return count > 0 ? sum / count : 0.0; }
};

struct Nees {
  Consistency pose, landmark;
  Consistency between;  ///< two landmarks each: what GPS and the first heading do not decide
};

/// The true place of an estimated landmark: nearest once the common error is taken out, which may
/// be as large as objects are apart.
inline const Eigen::Vector3d& TruthOf(const Eigen::Vector3d& p, const Alignment& alignment,
                                      const StreamTruth& truth) {
  const Eigen::Vector3d aligned = alignment.Apply(p);
  return std::ranges::min_element(
             truth.landmarks, {},
             [&aligned](const TrueLandmark& t) { return (t.p - aligned).norm(); })
      ->p;
}

/// Differences of landmarks under their joint covariance, each with the one found before it.
inline Consistency ConsistencyBetween(const Navigator& navigator, const StreamTruth& truth) {
  const Alignment alignment = ErrorOf(navigator.Smoothed(), truth).alignment;
  std::vector<int> slots;
  std::vector<Eigen::Vector3d> errors;
  for (const TrackedObject& object : navigator.tracker().objects()) {
    if (!object.is_landmark()) continue;
    slots.push_back(object.slot());
    errors.emplace_back(object.p_W - TruthOf(object.p_W, alignment, truth));
  }
  Consistency between;
  if (slots.size() < 2) return between;
  const JointCovariance joint = navigator.smoother().CovarianceOf({}, slots);
  for (Eigen::Index i = 1; i < static_cast<Eigen::Index>(slots.size()); ++i) {
    const Eigen::Matrix3d across = joint.block<3, 3>(3 * i, 3 * i - 3);
    const Eigen::Matrix3d covariance = joint.block<3, 3>(3 * i, 3 * i) +
                                       joint.block<3, 3>(3 * i - 3, 3 * i - 3) - across -
                                       across.transpose();
    between.Add(errors[static_cast<std::size_t>(i)] - errors[static_cast<std::size_t>(i) - 1],
                covariance);
  }
  return between;
}

inline Nees NeesOf(const ReplayResult& result, const StreamTruth& truth) {
  const Alignment alignment = ErrorOf(result.smoothed, truth).alignment;
  Nees nees;
  for (std::size_t i = 0; i < result.online.size(); i += 50) {
    nees.pose.Add(result.online[i].X_WB.p_WB - truth.At(result.online[i].t),
                  result.online_covariance_W[i]);
  }
  for (const Landmark& landmark : result.landmarks) {
    nees.landmark.Add(landmark.object.p_W - TruthOf(landmark.object.p_W, alignment, truth),
                      landmark.object.cov_W);
  }
  return nees;
}

}  // namespace limpet
