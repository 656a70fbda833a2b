// SPDX-License-Identifier: MIT
// Small sets like published ones through the smoother: the batch minimum is reached.
#include "tests/support/published_run.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "tests/support/published_sets.hpp"

namespace limpet {
namespace {

double NoTime() { return 0.0; }

/// Rounds of a square with closures to every place that was there before, and landmarks.
PlanarGraph SquareGraph(int poses, double noise, double turn_noise) {
  Random random(3);
  PlanarGraph graph;
  std::vector<Eigen::Vector3d> truth;
  const std::vector<Eigen::Vector2d> landmarks{{2.0, 7.0}, {7.0, 3.0}};
  const auto seen_from = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double c = std::cos(a.z()), s = std::sin(a.z());
    const Eigen::Vector3d d = b - a;
    return Eigen::Vector3d(c * d.x() + s * d.y(), -s * d.x() + c * d.y(), WrapAngle(d.z()));
  };
  const auto edge = [&](int from, int to) {
    PlanarEdge e{.from = from, .to = to};
    e.variance << noise * noise, noise * noise, turn_noise * turn_noise;
    e.motion =
        seen_from(truth[static_cast<std::size_t>(from)], truth[static_cast<std::size_t>(to)]);
    e.motion +=
        Eigen::Vector3d(random.Normal(noise), random.Normal(noise), random.Normal(turn_noise));
    return e;
  };
  for (int k = 0; k < poses; ++k) {
    const double side = k / 5 % 4, along = k % 5;
    const double yaw = 0.5 * std::numbers::pi * side;
    const Eigen::Vector2d corner(side == 0 || side == 3 ? 0.0 : 10.0, side < 2 ? 0.0 : 10.0);
    const Eigen::Vector2d p = corner + 2.0 * along * Eigen::Vector2d(std::cos(yaw), std::sin(yaw));
    truth.emplace_back(p.x(), p.y(), yaw);
    graph.poses.emplace_back(truth.back() +
                             Eigen::Vector3d(random.Normal(0.2), random.Normal(0.2), 0.0));
    if (k > 0) graph.edges.push_back(k % 2 == 0 ? edge(k - 1, k) : edge(k, k - 1));
    if (k >= 20) graph.edges.push_back(k % 3 == 0 ? edge(k, k - 20) : edge(k - 20, k));
    for (int j = 0; j < 2; ++j) {
      const Eigen::Vector3d d =
          seen_from(truth.back(), {landmarks[static_cast<std::size_t>(j)].x(),
                                   landmarks[static_cast<std::size_t>(j)].y(), 0.0});
      graph.sightings.push_back({.pose = k,
                                 .landmark = j,
                                 .bearing_range = {std::atan2(d.y(), d.x()) + random.Normal(0.03),
                                                   d.head<2>().norm() + random.Normal(0.1)},
                                 .sigma = {0.03, 0.1}});
    }
  }
  return graph;
}

TEST(PlanarRun, ReachesTheBatchMinimumThroughPlaces) {
  const SetResult result = RunPlanarGraph(SquareGraph(60, 0.1, 0.02), NoTime);
  EXPECT_EQ(result.places, 40);
  EXPECT_TRUE(result.finish.has_converged);
  EXPECT_LT(result.Excess(), 1e-6);
}

TEST(PlanarRun, ConvergesThoughTheNewestPosesWouldRatherMoveAlone) {
  // The newest poses hang on one another and on closures alone; were they moved before the step as
  // a whole is judged, the way back would be lost.
  PlanarGraph graph = SquareGraph(31, 0.1, 0.2);
  graph.sightings.clear();
  const SetResult result = RunPlanarGraph(graph, NoTime);
  EXPECT_TRUE(result.finish.has_converged);
  EXPECT_LT(result.Excess(), 1e-6);
}

TEST(PlanarRun, NeverLeavesTheSmootherWorseThanItWas) {
  // Odometry that says next to nothing, so that whole steps overshoot.
  for (const int poses : {18, 25, 31, 40, 46, 60}) {
    PlanarGraph graph = SquareGraph(poses, 1.0, 1.0);
    std::erase_if(graph.edges, [](const auto& e) { return std::abs(e.from - e.to) > 1; });
    const SetResult result = RunPlanarGraph(graph, NoTime);
    EXPECT_LE(result.cost, result.running_cost * (1.0 + 1e-9)) << poses;
  }
}

TEST(RangeRun, FindsBeaconsAndPosesFromOdometryAndRanges) {
  Random random(5);
  RangeSession session;
  session.beacons = {{3, {30.0, 10.0}}, {7, {-10.0, 25.0}}, {8, {10.0, -20.0}}};
  Eigen::Vector3d x = Eigen::Vector3d::Zero();
  session.truth.emplace_back(0.0, 0.0, 0.0, 0.0);
  for (int k = 1; k <= 800; ++k) {
    const double way = 0.3, turn = 0.012 + 0.02 * std::sin(0.02 * k);
    const double heading = x.z() + 0.5 * turn;
    x += Eigen::Vector3d(way * std::cos(heading), way * std::sin(heading), turn);
    session.truth.emplace_back(k, x.x(), x.y(), x.z());
    session.steps.push_back(
        {static_cast<double>(k), way + random.Normal(0.03), turn + random.Normal(0.002)});
    const auto beacon = std::next(session.beacons.begin(), k % 3);
    const double range = 1.05 * (beacon->second - x.head<2>()).norm() + random.Normal(0.3);
    session.ranges.push_back({static_cast<double>(k), beacon->first, range});
  }
  const SetResult result =
      RunRangeSession(session, {.range_sigma = 0.5, .has_own_scale = true}, NoTime);
  const SetError error = ErrorOfRangeSession(result, session);
  EXPECT_LT(result.Excess(), 1e-6);
  ASSERT_EQ(result.beacons.size(), 3U);
  EXPECT_LT(error.worst_beacon, 1.0);
  EXPECT_LT(error.poses, 0.6);
}

}  // namespace
}  // namespace limpet
