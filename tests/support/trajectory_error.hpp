// SPDX-License-Identifier: MIT
// Errors of a trajectory and of landmarks against the truth, absolute and aligned.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "estimation/replay/replay.hpp"
#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"

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
[[nodiscard]] LandmarkErrors ErrorsOf(const std::vector<Landmark>& landmarks,
                                      const Alignment& alignment, const StreamTruth& truth);

inline std::vector<std::vector<double>> ReadTable(const std::filesystem::path& file) {
  std::vector<std::vector<double>> rows;
  const Expected<StreamFile> read = ReadLines(file);
  for (const std::string& line : read ? read->lines : std::vector<std::string>()) {
    std::vector<double> row;
    for (const std::string& field : Split(line, ',')) {
      row.push_back(ParseNumber(field).value_or(0.0));
    }
    rows.push_back(row);
  }
  if (!rows.empty()) rows.erase(rows.begin());
  return rows;
}

inline StreamTruth LoadTruth(const std::filesystem::path& folder) {
  StreamTruth truth;
  for (const std::vector<double>& row : ReadTable(folder / "truth_traj.csv.gz")) {
    truth.t.push_back(row[0]);
    truth.p.emplace_back(row[1], row[2], row[3]);
  }
  for (const std::vector<double>& row : ReadTable(folder / "truth_landmarks.csv")) {
    truth.landmarks.push_back({static_cast<int>(row[0]), {row[1], row[2], row[3]}});
  }
  return truth;
}

inline Eigen::Vector3d StreamTruth::At(double time) const {
  const auto next = std::ranges::lower_bound(t, time);
  const auto i = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(next - t.begin(), 1, static_cast<std::ptrdiff_t>(t.size()) - 1));
  const double share = std::clamp((time - t[i - 1]) / (t[i] - t[i - 1]), 0.0, 1.0);
  return p[i - 1] + share * (p[i] - p[i - 1]);
}

inline Eigen::Vector3d Alignment::Apply(const Eigen::Vector3d& p) const {
  const double c = std::cos(turn), s = std::sin(turn);
  return Eigen::Vector3d(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z()) + shift;
}

inline TrajectoryError ErrorOf(const std::vector<SmoothedPose>& poses, const StreamTruth& truth) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero(), true_mean = Eigen::Vector3d::Zero();
  const auto n = static_cast<double>(poses.size());
  for (const SmoothedPose& pose : poses) {
    mean += pose.X_WB.p_WB / n;
    true_mean += truth.At(pose.t) / n;
  }
  double along = 0.0, across = 0.0;
  for (const SmoothedPose& pose : poses) {
    const Eigen::Vector3d a = pose.X_WB.p_WB - mean, b = truth.At(pose.t) - true_mean;
    along += a.x() * b.x() + a.y() * b.y();
    across += a.x() * b.y() - a.y() * b.x();
  }
  TrajectoryError error;
  error.alignment.turn = std::atan2(across, along);
  error.alignment.shift = true_mean - error.alignment.Apply(mean);
  for (const SmoothedPose& pose : poses) {
    const Eigen::Vector3d b = truth.At(pose.t);
    const Eigen::Vector3d aligned = error.alignment.Apply(pose.X_WB.p_WB) - b;
    error.absolute += (pose.X_WB.p_WB - b).squaredNorm() / n;
    error.aligned += aligned.squaredNorm() / n;
    error.aligned_horizontal += aligned.head<2>().squaredNorm() / n;
  }
  error.absolute = std::sqrt(error.absolute);
  error.aligned = std::sqrt(error.aligned);
  error.aligned_horizontal = std::sqrt(error.aligned_horizontal);
  return error;
}

inline LandmarkErrors ErrorsOf(const std::vector<Landmark>& landmarks, const Alignment& alignment,
                               const StreamTruth& truth) {
  constexpr double kSameObject = 1.5;  // [m] further off, an estimate shows nothing
  LandmarkErrors errors;
  std::map<int, int> found;
  for (const Landmark& landmark : landmarks) {
    const Eigen::Vector3d p = alignment.Apply(landmark.object.p_W);
    const auto nearest = std::ranges::min_element(
        truth.landmarks, {}, [&p](const TrueLandmark& t) { return (t.p - p).norm(); });
    const double error = (nearest->p - p).norm();
    if (error > kSameObject) {
      ++errors.false_ones;
      continue;
    }
    errors.duplicates += found[nearest->id]++ > 0 ? 1 : 0;
    errors.aligned_max = std::max(errors.aligned_max, error);
    errors.aligned_mean += error;
    errors.absolute_max = std::max(errors.absolute_max, (landmark.object.p_W - nearest->p).norm());
  }
  const auto matched = landmarks.size() - static_cast<std::size_t>(errors.false_ones);
  errors.aligned_mean /= std::max<double>(static_cast<double>(matched), 1.0);
  for (const TrueLandmark& landmark : truth.landmarks) {
    if (!found.contains(landmark.id)) errors.missed.push_back(landmark.id);
  }
  return errors;
}

}  // namespace limpet
