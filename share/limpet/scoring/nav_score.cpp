// SPDX-License-Identifier: MIT
#include "limpet/scoring/nav_score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limpet/core/cross_product.hpp"
#include "limpet/topics/survey_phase.hpp"

namespace limpet {
namespace {

/// An estimate and the truth at the same time.
struct PosePair {
  Eigen::Vector3d estimate, truth;
};

/// Least squares over shift and yaw: the horizontal Procrustes problem without scale.
CommonOffset Align(const std::vector<PosePair>& pairs) {
  CommonOffset offset;
  if (pairs.empty()) return offset;
  for (const PosePair& pair : pairs) {
    offset.pivot_W += pair.estimate;
    offset.target_W += pair.truth;
  }
  offset.pivot_W /= static_cast<double>(pairs.size());
  offset.target_W /= static_cast<double>(pairs.size());
  double sine = 0.0, cosine = 0.0;
  for (const PosePair& pair : pairs) {
    const Eigen::Vector3d a = pair.estimate - offset.pivot_W;
    const Eigen::Vector3d b = pair.truth - offset.target_W;
    cosine += a.x() * b.x() + a.y() * b.y();
    sine += CrossOf(a.head<2>(), b.head<2>());
  }
  offset.yaw = std::atan2(sine, cosine);
  return offset;
}

/// Error of the place at the track's last time that is not after `end_s` [m].
std::optional<double> ErrorAtEnd(const PoseTrack& track, const PoseTrack& truth, double end_s) {
  for (std::size_t i = track.size(); i-- > 0;) {
    if (track.time(i) > end_s) continue;
    if (const auto X_WB = truth.At(track.time(i))) return (track.position(i) - X_WB->p_WB).norm();
  }
  return std::nullopt;
}

std::optional<double> RootMeanSquare(double sum_of_squares, std::size_t count) {
  if (count == 0) return std::nullopt;
  return std::sqrt(sum_of_squares / static_cast<double>(count));
}

/// Squared error over variance of the three axes; an axis whose deviation is not given is left out
/// by returning nothing.
std::optional<double> NormalisedSquare(const Eigen::Vector3d& error,
                                       const std::array<float, 4>& sd) {
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double sigma = sd[static_cast<std::size_t>(axis)];
    if (!(sigma > 0.0)) return std::nullopt;
    sum += (error[axis] / sigma) * (error[axis] / sigma);
  }
  return sum;
}

void AppendTo(NavErrorCurve& curve, const Eigen::Vector3d& error, const std::array<float, 4>& sd) {
  curve.error_m.push_back(error.norm());
  curve.north_m.push_back(error.x());
  curve.east_m.push_back(error.y());
  curve.down_m.push_back(error.z());
  curve.sd_north_m.push_back(static_cast<double>(sd[0]));
  curve.sd_east_m.push_back(static_cast<double>(sd[1]));
  curve.sd_down_m.push_back(static_cast<double>(sd[2]));
}

}  // namespace

Eigen::Vector3d CommonOffset::Apply(const Eigen::Vector3d& estimate_W) const {
  const Eigen::Vector3d a = estimate_W - pivot_W;
  const double c = std::cos(yaw), s = std::sin(yaw);
  return target_W + Eigen::Vector3d(c * a.x() - s * a.y(), s * a.x() + c * a.y(), a.z());
}

NavScore ScoreNavigation(const SessionRecord& record, double start_s) {
  NavScore score;
  const double start_path = record.truth.PathAt(start_s);
  std::vector<PosePair> pairs;
  double squares = 0.0, nees = 0.0;
  std::size_t nees_count = 0;
  for (std::size_t i = 0; i < record.nav.size(); ++i) {
    const double time = record.nav.time(i);
    const auto X_WB = record.truth.At(time);
    if (time < start_s || !X_WB) continue;
    pairs.push_back({record.nav.position(i), X_WB->p_WB});
    const Eigen::Vector3d error = pairs.back().estimate - pairs.back().truth;
    squares += error.squaredNorm();
    if (const auto square = NormalisedSquare(error, record.nav_sd[i])) {
      nees += *square;
      ++nees_count;
    }
    score.curve.time_s.push_back(time - start_s);
    score.curve.path_m.push_back(record.truth.PathAt(time) - start_path);
    AppendTo(score.curve, error, record.nav_sd[i]);
  }
  for (std::size_t i = 0; i < record.dead_reckoning.size(); ++i) {
    const double time = record.dead_reckoning.time(i);
    const auto X_WB = record.truth.At(time);
    if (time < start_s || !X_WB) continue;
    score.curve.dead_reckoning_time_s.push_back(time - start_s);
    score.curve.dead_reckoning_m.push_back((record.dead_reckoning.position(i) - X_WB->p_WB).norm());
  }
  score.offset = Align(pairs);
  double aligned_squares = 0.0;
  for (const PosePair& pair : pairs) {
    aligned_squares += (score.offset.Apply(pair.estimate) - pair.truth).squaredNorm();
  }
  score.position_rmse_m = RootMeanSquare(squares, pairs.size());
  score.aligned_rmse_m = RootMeanSquare(aligned_squares, pairs.size());
  // At the surface GPS returns: from then on it is no longer the survey's drift that shows.
  const auto ascent = record.PhaseStart(SurveyPhase::kAscend);
  const double end_s = ascent ? ascent->value() : std::numeric_limits<double>::infinity();
  score.final_error_m = ErrorAtEnd(record.nav, record.truth, end_s);
  score.dead_reckoning_final_error_m = ErrorAtEnd(record.dead_reckoning, record.truth, end_s);
  if (nees_count > 0) score.nees_mean = nees / static_cast<double>(nees_count);
  return score;
}

}  // namespace limpet
