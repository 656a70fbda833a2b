// SPDX-License-Identifier: MIT
#include "estimation/smoothing/damped_step.hpp"

#include "estimation/smoothing/arrow_elimination.hpp"

namespace limpet {
namespace {

constexpr double kLeastShare = 1e-3;
constexpr double kRounding = 1e-9;  // relative, by which a cost may rise

}  // namespace

ChainValues ValuesOf(const ChainGraph& graph) {
  ChainValues values;
  for (int i = 0; i < graph.node_count(); ++i)
    values.poses.push_back(graph.node(i).x);
  for (int slot = 0; slot < graph.slot_count(); ++slot)
    values.border.push_back(graph.border(slot).x);
  return values;
}

void SetValues(const ChainValues& values, ChainGraph& graph) {
  for (int i = 0; i < graph.node_count(); ++i)
    graph.node(i).x = values.poses[AsIndex(i)];
  for (int slot = 0; slot < graph.slot_count(); ++slot)
    graph.border(slot).x = values.border[AsIndex(slot)];
}

DampedStep StepTowards(const ChainValues& from, const ChainValues& to, double cost_before,
                       ChainGraph& graph) {
  for (double share = 1.0;; share = share > kLeastShare ? 0.5 * share : 0.0) {
    for (int i = 0; i < graph.node_count(); ++i) {
      const NavVector& x = from.poses[AsIndex(i)];
      graph.node(i).x = x + share * (to.poses[AsIndex(i)] - x);
    }
    for (int slot = 0; slot < graph.slot_count(); ++slot) {
      const Eigen::Vector3d& p = from.border[AsIndex(slot)];
      graph.border(slot).x = p + share * (to.border[AsIndex(slot)] - p);
    }
    const double cost = graph.Cost();
    const bool rises = cost > cost_before * (1.0 + kRounding);
    if (!rises || share <= 0.0) return {cost, share};
  }
}

}  // namespace limpet
