// SPDX-License-Identifier: MIT
// What an earlier session over a scene's place left, in a frame of its own, and how much of it the
// later one knows again.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "estimation/replay/replay.hpp"
#include "limpet/core/random.hpp"
#include "tests/support/simulated_stream.hpp"

namespace limpet {

/// How far a former session's frame lies off, and what has changed since.
struct FormerFrame {
  double changed = 0.125;                ///< share of the objects that went, and as many came
  double shift_m = 0.0, turn_deg = 0.0;  ///< half to all of it, to any side
  bool is_of_another_place = false;      ///< nothing of it is here
};

struct EarlierSession {
  FormerSession former;
  std::map<int, int> true_ids;  ///< of its landmarks
};

struct Recognition {
  int possible = 0, right = 0, wrong = 0;
};

/// The true object nearest to a landmark, if it is near.
inline std::optional<int> TrueIdAt(const Eigen::Vector3d& p_W, const Alignment& alignment,
                                   const StreamTruth& truth) {
  constexpr double kNear = 1.0;  // [m]
  const Eigen::Vector3d p = alignment.Apply(p_W);
  const auto nearest = std::ranges::min_element(
      truth.landmarks, {}, [&p](const TrueLandmark& l) { return (l.p - p).norm(); });
  const bool is_near =
      nearest != truth.landmarks.end() && (nearest->p - p).head<2>().norm() < kNear;
  return is_near ? std::optional(nearest->id) : std::nullopt;
}

/// Makes the scene a later one.
inline EarlierSession EarlierOf(StreamScene& scene, const FormerFrame& frame) {
  StreamScene first = scene;
  first.place = scene.place = scene.seed;
  first.seed += 100000;
  scene.gone = scene.came =
      std::max(static_cast<int>(std::lround(frame.changed * scene.objects)), 1);
  if (frame.is_of_another_place) first.place += 50000;
  const SimulatedStream session = SimulateStream(first);
  const ReplayResult result =
      Replay(session.stream, ParamsForStream(session.stream.meta), [] { return 0.0; });
  const Alignment alignment = ErrorOf(result.smoothed, session.truth).alignment;
  Random random(scene.seed, "former frame");
  const double way = random.Uniform(0.0, 2.0 * std::numbers::pi);
  const double shift = random.Uniform(0.5, 1.0) * frame.shift_m;
  const double turn = (random.Chance(0.5) ? 1.0 : -1.0) * random.Uniform(0.5, 1.0) *
                      frame.turn_deg * std::numbers::pi / 180.0;
  Eigen::Matrix3d R = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  EarlierSession earlier;
  for (const Landmark& l : result.landmarks) {
    const auto id = TrueIdAt(l.object.p_W, alignment, session.truth);
    if (id && !frame.is_of_another_place) earlier.true_ids[l.id] = *id;
    const Eigen::Vector3d p =
        R * l.object.p_W + shift * Eigen::Vector3d(std::cos(way), std::sin(way), 0.0);
    earlier.former.objects.push_back(
        {.id = l.id,
         .object = {
             .p_W = p, .cov_W = R * l.object.cov_W * R.transpose(), .color = l.object.color}});
  }
  Eigen::MatrixXd& covariance = earlier.former.joint_cov_W = result.landmark_covariance;
  for (Eigen::Index i = 0; i + 2 < covariance.rows(); i += 3) {
    covariance.middleRows<3>(i) = (R * covariance.middleRows<3>(i)).eval();
    covariance.middleCols<3>(i) = (covariance.middleCols<3>(i) * R.transpose()).eval();
  }
  return earlier;
}

/// Landmarks that the former session had as well, those known again as what they are, and those
/// taken for another.
inline Recognition RecognitionOf(const ReplayResult& result, const EarlierSession& earlier,
                                 const StreamTruth& truth, const Alignment& alignment) {
  Recognition recognition;
  for (const Landmark& l : result.landmarks) {
    const std::optional<int> id = TrueIdAt(l.object.p_W, alignment, truth);
    const auto was = std::ranges::find_if(
        earlier.true_ids, [&id](const auto& entry) { return id && entry.second == *id; });
    const bool was_known = was != earlier.true_ids.end();
    recognition.possible += was_known ? 1 : 0;
    if (!l.former.id) continue;
    const auto said = earlier.true_ids.find(*l.former.id);
    const bool is_right = was_known && said != earlier.true_ids.end() && said->second == *id;
    (is_right ? recognition.right : recognition.wrong) += 1;
  }
  return recognition;
}

}  // namespace limpet
