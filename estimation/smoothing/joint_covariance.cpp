// SPDX-License-Identifier: MIT
#include "estimation/smoothing/joint_covariance.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "estimation/smoothing/covariance_descent.hpp"
#include "limpet/core/require.hpp"

namespace limpet {
namespace {

using Rows = std::vector<Eigen::Index>;

constexpr double kUnknown = 1e8;  // [m^2] of a border variable that no update has seen yet

CovarianceDescent DescendTo(const VariableList& variables, const ArrowChain& chain,
                            const ArrowEstimates& estimates, const ArrowRoot& root) {
  const ArrowLeaf& open = chain.open_leaf();
  CovarianceDescent descent(root.WholeCovariance(), root.slots(), open.anchor(), open.head());
  const auto go_to = [&](int leaf) {
    for (const ArrowStretch* stretch : chain.tree().PathTo(leaf))
      descent.Place(*stretch);
  };
  for (const int node : variables.nodes) {
    const int leaf = chain.LeafOf(node);
    const bool is_open = leaf == chain.tree().size();
    if (!is_open) go_to(leaf);
    if (!descent.HasPose(node)) descent.WalkInto(is_open ? open : chain.tree().leaf(leaf), node);
  }
  for (const int slot : variables.slots) {
    if (estimates.IsSolved(slot) && !descent.HasBlock(slot)) go_to(chain.status(slot).leaves->last);
  }
  return descent;
}

/// Collects covariances of border variables, each alone, on the way down.
class MarginalCollector {
 public:
  /// Nothing is known of those that are in no stretch.
  MarginalCollector(const std::vector<int>& slots, const ArrowChain& chain)
      : chain_(chain),
        slots_(slots),
        covariances_(slots.size(), kUnknown * Eigen::Matrix3d::Identity()) {}

  void Collect(const CovarianceDescent& root, const ArrowEstimates& estimates) {
    std::vector<std::size_t> below;
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      if (!Take(root, i) && estimates.IsSolved(slots_[i]) && chain_.IsClosed(slots_[i]))
        below.push_back(i);
    }
    Follow(root, below, 0);
  }
  [[nodiscard]] const std::vector<Eigen::Matrix3d>& covariances() const { return covariances_; }

 private:
  bool Take(const CovarianceDescent& descent, std::size_t i) {
    if (!descent.HasBlock(slots_[i])) return false;
    const Eigen::Index row = descent.RowOfBlock(slots_[i]);
    covariances_[i] = descent.S().block<3, 3>(row, row);
    return true;
  }
  [[nodiscard]] std::vector<const ArrowStretch*> PathTo(std::size_t i) const {
    return chain_.tree().PathTo(chain_.status(slots_[i]).leaves->last);
  }
  /// `below`: of the slots, those that stretches at this depth of the tree or below eliminated.
  /// REQUIRES: all have the same way so far.
  void Follow(const CovarianceDescent& above, std::vector<std::size_t> below, std::size_t depth) {
    while (!below.empty()) {
      const std::vector<const ArrowStretch*> path = PathTo(below.front());
      if (depth >= path.size()) return;
      const ArrowStretch* stretch = path[depth];
      const auto elsewhere = std::partition(below.begin(), below.end(), [&](std::size_t i) {
        const std::vector<const ArrowStretch*> way = PathTo(i);
        return depth < way.size() && way[depth] == stretch;
      });
      // While joins wait, a stretch may depend on more than those above it know of.
      CovarianceDescent here = chain_.tree().is_fresh() ? above.At(*stretch) : above;
      here.Place(*stretch);
      std::vector<std::size_t> further;
      std::copy_if(below.begin(), elsewhere, std::back_inserter(further),
                   [&](std::size_t i) { return !Take(here, i); });
      Follow(here, std::move(further), depth + 1);
      below.erase(below.begin(), elsewhere);
    }
  }

  const ArrowChain& chain_;
  const std::vector<int>& slots_;
  std::vector<Eigen::Matrix3d> covariances_;
};

/// Collects covariances of poses, each alone, on the way down.
class PoseCollector {
 public:
  explicit PoseCollector(const ArrowChain& chain)
      : chain_(chain), covariances_(AsIndex(chain.open_leaf().head() + 1)) {}

  void Collect(const CovarianceDescent& root) {
    Take(root, chain_.open_leaf());
    Follow(root, 0, chain_.tree().size(), 0);
  }
  [[nodiscard]] std::vector<NavCovariance> Result() && { return std::move(covariances_); }

 private:
  /// Leaves `first` to `end` - 1. REQUIRES: all have the same way so far, and it has been gone.
  void Follow(const CovarianceDescent& above, int first, int end, std::size_t depth) {
    while (first < end) {
      const std::vector<const ArrowStretch*> path = chain_.tree().PathTo(first);
      if (depth >= path.size()) {
        Take(above, chain_.tree().leaf(first++));
        continue;
      }
      const ArrowStretch* stretch = path[depth];
      int next = first + 1;
      for (; next < end; ++next) {
        const std::vector<const ArrowStretch*> way = chain_.tree().PathTo(next);
        if (depth >= way.size() || way[depth] != stretch) break;
      }
      // While joins wait, a stretch may depend on more than those above it know of.
      CovarianceDescent here = chain_.tree().is_fresh() ? above.At(*stretch) : above;
      here.Place(*stretch);
      Follow(here, first, next, depth + 1);
      first = next;
    }
  }
  void Take(CovarianceDescent descent, const ArrowLeaf& leaf) {
    if (leaf.head() > leaf.anchor()) descent.WalkInto(leaf, leaf.anchor() + 1);
    for (int node = leaf.anchor(); node <= leaf.head(); ++node) {
      const Eigen::Index row = descent.RowOf(node);
      covariances_[AsIndex(node)] = descent.S().block<6, 6>(row, row);
    }
  }

  const ArrowChain& chain_;
  std::vector<NavCovariance> covariances_;
};

}  // namespace

std::vector<NavCovariance> PoseCovariances(const ArrowChain& chain, const ArrowRoot& root) {
  LIMPET_REQUIRE(chain.has_begun(), "a first update");
  const ArrowLeaf& open = chain.open_leaf();
  PoseCollector collector(chain);
  collector.Collect({root.WholeCovariance(), root.slots(), open.anchor(), open.head()});
  return std::move(collector).Result();
}

std::vector<Eigen::Matrix3d> BorderCovariances(const std::vector<int>& slots,
                                               const ArrowChain& chain,
                                               const ArrowEstimates& estimates,
                                               const ArrowRoot& root) {
  const ArrowLeaf& open = chain.open_leaf();
  MarginalCollector collector(slots, chain);
  collector.Collect({root.WholeCovariance(), root.slots(), open.anchor(), open.head()}, estimates);
  return collector.covariances();
}

JointCovariance CovarianceOf(const VariableList& variables, const ArrowChain& chain,
                             const ArrowEstimates& estimates, const ArrowRoot& root) {
  LIMPET_REQUIRE(std::ranges::all_of(variables.nodes,
                                     [&chain](int node) {
                                       return chain.has_begun() && node >= 0 &&
                                              node <= chain.open_leaf().head();
                                     }),
                 "nodes that an update has seen");
  const CovarianceDescent descent = DescendTo(variables, chain, estimates, root);
  // Gather what was asked for, in its order; border variables that nobody knows stay so.
  Rows from, to;
  for (const int node : variables.nodes)
    AppendRows(from, descent.RowOf(node), 6);
  AppendRows(to, 0, static_cast<Eigen::Index>(from.size()));
  auto size = static_cast<Eigen::Index>(from.size());
  for (const int slot : variables.slots) {
    if (estimates.IsSolved(slot) && descent.HasBlock(slot)) {
      AppendRows(from, descent.RowOfBlock(slot), 3);
      AppendRows(to, size, 3);
    }
    size += 3;
  }
  JointCovariance joint = kUnknown * JointCovariance::Identity(size, size);
  joint(to, to) = descent.S()(from, from);
  return joint;
}

JointCovariance HeadCovariance(const std::vector<int>& slots, const ArrowEstimates& estimates,
                               const ArrowRoot& root) {
  std::vector<int> solved;
  Rows rows{0, 1, 2, 3, 4, 5};
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (!estimates.IsSolved(slots[i])) continue;
    solved.push_back(slots[i]);
    AppendRows(rows, static_cast<Eigen::Index>(6 + 3 * i), 3);
  }
  JointCovariance known = root.Covariance(solved);
  if (solved.size() == slots.size()) {
    return known;
  }
  const auto n = static_cast<Eigen::Index>(6 + 3 * slots.size());
  JointCovariance joint = kUnknown * JointCovariance::Identity(n, n);
  joint(rows, rows) = known;
  return joint;
}

}  // namespace limpet
