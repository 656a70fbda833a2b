// SPDX-License-Identifier: MIT
// Runs published sets through the chain's smoother and its batch oracle.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "estimation/smoothing/arrow_smoother.hpp"
#include "tests/support/published_sets.hpp"

namespace limpet {

/// What came of a set. Costs are sums of losses; the batch minimum is the lower one of two batch
/// solutions, from the smoother's result and from a start of its own.
struct SetResult {
  int poses = 0, places = 0, landmarks = 0;
  double running_cost = 0.0;  ///< where the updates alone left it
  double cost = 0.0;          ///< after Converge
  double batch_cost = 0.0;
  SolveReport finish;
  std::vector<double> update_s;
  double converge_s = 0.0, batch_s = 0.0;
  std::vector<NavVector> smoothed;
  std::map<int, Eigen::Vector2d> beacons;

  /// Share by which the cost exceeds the batch minimum.
  [[nodiscard]] double Excess() const { return cost / std::max(batch_cost, 1e-9) - 1.0; }
};

struct RangeSessionParams {
  double way_sigma = 0.03;     ///< of one step [m], along and across
  double turn_sigma = 0.002;   ///< [rad]
  double range_sigma = 1.0;    ///< [m]
  double huber = 2.0;          ///< whitened
  bool has_own_scale = false;  ///< each beacon's ranges are off by a scale that is estimated
};

/// `clock` [s] times the updates. Poses are taken in order of their numbers, each with its edges to
/// earlier ones; edges that skip poses go through places. REQUIRES: every pose but the first has an
/// edge to the one before it.
[[nodiscard]] SetResult RunPlanarGraph(const PlanarGraph& graph,
                                       const std::function<double()>& clock);
/// Beacons come in when their ranges tell where they are.
[[nodiscard]] SetResult RunRangeSession(const RangeSession& session,
                                        const RangeSessionParams& params,
                                        const std::function<double()>& clock);

/// Root mean square distance [m] of the smoothed poses from the truth, and the worst beacon's.
struct SetError {
  double poses = 0.0, worst_beacon = 0.0;
};
[[nodiscard]] SetError ErrorOfRangeSession(const SetResult& result, const RangeSession& session);

}  // namespace limpet
