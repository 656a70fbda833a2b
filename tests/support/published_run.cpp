// SPDX-License-Identifier: MIT
#include "tests/support/published_run.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "estimation/smoothing/factors/border_prior_factor.hpp"
#include "estimation/smoothing/factors/pose_prior_factor.hpp"
#include "limpet/core/require.hpp"
#include "tests/support/batch_solver.hpp"
#include "tests/support/beacon_start.hpp"
#include "tests/support/distance_factor.hpp"
#include "tests/support/planar_factors.hpp"

namespace limpet {
namespace {

constexpr double kPlaneSigma = 0.01;  // [m], [rad]: how a planar pose is held in the plane
constexpr double kStartSigma = 1e-3;  // [m], [rad] of the first pose
constexpr double kTieSigma = 1e-3;    // [m], [rad] of a place on its pose: far below any edge's
constexpr double kLevel = 1.0;        // [m^2] of a step's vertical part

NavVector InPlane(const Eigen::Vector3d& x_y_yaw) {
  NavVector x = NavVector::Zero();
  x(kNavX) = x_y_yaw.x(), x(kNavY) = x_y_yaw.y(), x(kNavYaw) = x_y_yaw.z();
  return x;
}

/// `motion` on, seen from `from`.
NavVector Moved(const NavVector& from, const Eigen::Vector3d& motion) {
  NavVector to = from;
  const double c = std::cos(from(kNavYaw)), s = std::sin(from(kNavYaw));
  to(kNavX) += c * motion.x() - s * motion.y();
  to(kNavY) += s * motion.x() + c * motion.y();
  to(kNavYaw) += motion.z();
  return to;
}

Eigen::Vector3d Backward(const Eigen::Vector3d& motion) {
  const double c = std::cos(motion.z()), s = std::sin(motion.z());
  return {-c * motion.x() - s * motion.y(), s * motion.x() - c * motion.y(), -motion.z()};
}

XyzYawFactor FactorOf(const PlanarEdge& edge) {
  return {Eigen::Vector4d(edge.motion.x(), edge.motion.y(), 0.0, edge.motion.z()),
          Eigen::Vector4d(edge.variance.x(), edge.variance.y(), kLevel, edge.variance.z())};
}

/// A smoother that takes planar sets, and what is asked of it at the end.
class SetRunner {
 public:
  explicit SetRunner(const std::function<double()>& clock) : clock_(clock) {}

  void Begin(const NavVector& x) {
    smoother_.AddNode(x, std::nullopt);
    smoother_.AddTerm(0, Term::OnPose(PosePriorFactor(x, NavVector::Constant(kStartSigma))));
  }
  void Step(const PlanarEdge& edge) {
    const int k = edge.from < edge.to ? edge.to : edge.from;
    const NavVector before = smoother_.PoseAt(k - 1);
    if (edge.to == k) {
      smoother_.AddNode(Moved(before, edge.motion), Term::OnStep(FactorOf(edge)));
    } else {
      smoother_.AddNode(Moved(before, Backward(edge.motion)),
                        Term::OnStep(BackwardFactor(FactorOf(edge))));
    }
    smoother_.AddTerm(k, Term::OnPose(PlaneFactor(kPlaneSigma)));
  }
  void Close(const PlanarEdge& edge) {
    const int earlier = std::min(edge.from, edge.to), later = std::max(edge.from, edge.to);
    const auto [found, is_new] = places_.try_emplace(earlier, -1);
    if (is_new) {
      const NavVector x = smoother_.PoseAt(earlier);
      found->second = smoother_.AddLandmark({x(kNavX), x(kNavY), x(kNavYaw)});
      smoother_.AddTerm(earlier, Term::OnObservation(PlaceFactor(kTieSigma), found->second));
    }
    const PlaceEdgeFactor factor(FactorOf(edge), edge.from == earlier);
    smoother_.AddTerm(later, Term::OnObservation(factor, found->second));
  }
  void Update() {
    const double start = clock_();
    smoother_.Update();
    result_.update_s.push_back(clock_() - start);
  }
  [[nodiscard]] ArrowSmoother& smoother() { return smoother_; }

  /// `restart` puts a copy of the graph where the oracle is to begin anew.
  SetResult Finish(const std::function<void(ChainGraph&)>& restart) {
    result_.poses = smoother_.graph().node_count();
    result_.places = static_cast<int>(places_.size());
    ChainGraph running = smoother_.graph();
    for (int i = 0; i < running.node_count(); ++i)
      running.node(i).x = smoother_.PoseAt(i);
    for (int slot = 0; slot < running.slot_count(); ++slot)
      running.border(slot).x = smoother_.BorderAt(slot);
    result_.running_cost = running.Cost();
    const double start = clock_();
    result_.finish = smoother_.Converge();
    result_.converge_s = clock_() - start;
    result_.cost = result_.finish.cost;
    ChainGraph near = smoother_.graph(), anew = near;
    const double batch_start = clock_();
    result_.batch_cost = SolveBatch(near, 100).cost;
    result_.batch_s = clock_() - batch_start;
    restart(anew);
    result_.batch_cost = std::min(result_.batch_cost, SolveBatch(anew, 100).cost);
    for (int i = 0; i < result_.poses; ++i)
      result_.smoothed.push_back(smoother_.PoseAt(i));
    return std::move(result_);
  }
  [[nodiscard]] SetResult& result() { return result_; }
  [[nodiscard]] const std::map<int, int>& places() const { return places_; }

 private:
  const std::function<double()>& clock_;
  ArrowSmoother smoother_;
  std::map<int, int> places_;  ///< block of the border, by pose
  SetResult result_;
};

/// Beacons of a range session: tentative until their ranges tell where they are.
class Beacons {
 public:
  Beacons(ArrowSmoother& smoother, const RangeSessionParams& params)
      : smoother_(smoother), params_(params) {}

  void Take(int node, const BeaconRange& range) {
    Beacon& beacon = beacons_[range.beacon];
    if (beacon.slot >= 0) {
      AddRange(beacon.slot, node, range.range);
      return;
    }
    beacon.waiting.emplace_back(node, range.range);
    std::vector<RangeFrom> ranges;
    for (const auto& [from, measured] : beacon.waiting) {
      ranges.push_back({smoother_.PoseAt(from).head<2>(), measured});
    }
    const auto start = StartOfBeacon(ranges, params_.range_sigma);
    if (!start) return;
    beacon.slot = smoother_.AddLandmark({start->x(), start->y(), 0.0});
    // The third number is the height, or the scale.
    const double third = params_.has_own_scale ? 0.1 : 1e-3;
    const BorderPriorFactor prior({start->x(), start->y(), 0.0},
                                  Eigen::Vector3d(1e6, 1e6, third * third).asDiagonal());
    smoother_.AddBorderTerm(beacon.slot, Term::OnBorder(prior, beacon.slot));
    for (const auto& [from, measured] : beacon.waiting)
      AddRange(beacon.slot, from, measured);
    beacon.waiting.clear();
  }
  [[nodiscard]] std::map<int, int> Slots() const {
    std::map<int, int> slots;
    for (const auto& [id, beacon] : beacons_) {
      if (beacon.slot >= 0) slots[id] = beacon.slot;
    }
    return slots;
  }

 private:
  struct Beacon {
    int slot = -1;
    std::vector<std::pair<int, double>> waiting;  ///< node, range
  };
  void AddRange(int slot, int node, double range) {
    const Loss loss = Loss::Huber(params_.huber);
    if (params_.has_own_scale) {
      const ScaledDistanceFactor factor(range, params_.range_sigma);
      smoother_.AddTerm(node, Term::OnObservation(factor, slot, loss));
    } else {
      const DistanceFactor factor(Meters(range), Meters(params_.range_sigma));
      smoother_.AddTerm(node, Term::OnObservation(factor, slot, loss));
    }
  }
  ArrowSmoother& smoother_;
  RangeSessionParams params_;
  std::map<int, Beacon> beacons_;
};

}  // namespace

SetResult RunPlanarGraph(const PlanarGraph& graph, const std::function<double()>& clock) {
  SetRunner runner(clock);
  const auto count = static_cast<int>(graph.poses.size());
  std::vector<std::vector<PlanarEdge>> edges(graph.poses.size());
  for (const PlanarEdge& edge : graph.edges)
    edges[AsIndex(std::max(edge.from, edge.to))].push_back(edge);
  std::vector<std::vector<PlanarSighting>> sightings(graph.poses.size());
  for (const PlanarSighting& sighting : graph.sightings)
    sightings[AsIndex(sighting.pose)].push_back(sighting);
  std::map<int, int> landmarks;
  for (int k = 0; k < count; ++k) {
    std::vector<PlanarEdge>& of_pose = edges[AsIndex(k)];
    if (k == 0) {
      runner.Begin(InPlane(graph.poses.front()));
    } else {
      const auto step = std::ranges::find_if(
          of_pose, [k](const PlanarEdge& e) { return std::min(e.from, e.to) == k - 1; });
      LIMPET_REQUIRE(step != of_pose.end(), "every pose has an edge to the one before it");
      runner.Step(*step);
      of_pose.erase(step);
    }
    for (const PlanarEdge& edge : of_pose)
      runner.Close(edge);
    for (const PlanarSighting& seen : sightings[AsIndex(k)]) {
      const auto [slot, is_new] = landmarks.try_emplace(seen.landmark, -1);
      if (is_new) {
        const NavVector x = runner.smoother().PoseAt(k);
        const double way = x(kNavYaw) + seen.bearing_range(0), range = seen.bearing_range(1);
        slot->second = runner.smoother().AddLandmark(
            {x(kNavX) + range * std::cos(way), x(kNavY) + range * std::sin(way), 0.0});
      }
      const BearingRangeFactor factor(seen.bearing_range, seen.sigma);
      runner.smoother().AddTerm(k, Term::OnObservation(factor, slot->second));
    }
    runner.Update();
  }
  runner.result().landmarks = static_cast<int>(landmarks.size());
  // The oracle begins at the file's own guess.
  return runner.Finish([&](ChainGraph& anew) {
    for (int i = 0; i < count; ++i)
      anew.node(i).x = InPlane(graph.poses[AsIndex(i)]);
    for (const auto& [pose, slot] : runner.places())
      anew.border(slot).x = graph.poses[AsIndex(pose)];
  });
}

SetResult RunRangeSession(const RangeSession& session, const RangeSessionParams& params,
                          const std::function<double()>& clock) {
  SetRunner runner(clock);
  Beacons beacons(runner.smoother(), params);
  const Eigen::Vector3d start =
      session.truth.empty() ? Eigen::Vector3d::Zero() : session.truth.front().tail<3>().eval();
  runner.Begin(InPlane(start));
  std::vector<NavVector> reckoned{InPlane(start)};
  const double way = params.way_sigma * params.way_sigma;
  auto range = session.ranges.begin();
  for (std::size_t k = 0; k < session.steps.size(); ++k) {
    const RollingStep& step = session.steps[k];
    const double half = 0.5 * step.turn;
    const auto node = static_cast<int>(k) + 1;
    const PlanarEdge edge{
        .from = node - 1,
        .to = node,
        .motion = {step.way * std::cos(half), step.way * std::sin(half), step.turn},
        .variance = {way, way, params.turn_sigma * params.turn_sigma}};
    runner.Step(edge);
    reckoned.push_back(Moved(reckoned.back(), edge.motion));
    for (; range != session.ranges.end() && range->t <= step.t; ++range)
      beacons.Take(node, *range);
    runner.Update();
  }
  const std::map<int, int> slots = beacons.Slots();
  runner.result().landmarks = static_cast<int>(slots.size());
  // The oracle begins at the odometry, with the beacons where the truth has them.
  SetResult result = runner.Finish([&](ChainGraph& anew) {
    for (int i = 0; i < anew.node_count(); ++i)
      anew.node(i).x = reckoned[AsIndex(i)];
    for (const auto& [id, slot] : slots) {
      const auto known = session.beacons.find(id);
      if (known == session.beacons.end()) continue;
      anew.border(slot).x = {known->second.x(), known->second.y(), 0.0};
    }
  });
  for (const auto& [id, slot] : slots)
    result.beacons[id] = runner.smoother().BorderAt(slot).head<2>();
  return result;
}

SetError ErrorOfRangeSession(const SetResult& result, const RangeSession& session) {
  SetError error;
  // Row k of the truth belongs to pose k: both are the odometry's times.
  const std::size_t count = std::min(result.smoothed.size(), session.truth.size());
  for (std::size_t k = 0; k < count; ++k) {
    error.poses += (result.smoothed[k].head<2>() - session.truth[k].segment<2>(1)).squaredNorm();
  }
  error.poses = std::sqrt(error.poses / std::max<double>(static_cast<double>(count), 1.0));
  for (const auto& [id, p] : result.beacons) {
    const auto known = session.beacons.find(id);
    if (known == session.beacons.end()) continue;
    error.worst_beacon = std::max(error.worst_beacon, (p - known->second).norm());
  }
  return error;
}

}  // namespace limpet
