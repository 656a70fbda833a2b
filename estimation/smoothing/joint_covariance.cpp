// SPDX-License-Identifier: MIT
#include "estimation/smoothing/joint_covariance.hpp"

#include <algorithm>
#include <map>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

using Rows = std::vector<Eigen::Index>;

constexpr double kUnknown = 1e8;  // [m^2] of a border variable that no update has seen yet

void Append(Rows& rows, Eigen::Index first, Eigen::Index count) {
  for (Eigen::Index i = 0; i < count; ++i)
    rows.push_back(first + i);
}

/// Joint covariance of all variables that the way down has come to.
class CovarianceDescent {
 public:
  /// `whole`: of (last anchor, blocks `slots`, head), which are nodes of the chain.
  CovarianceDescent(const Eigen::MatrixXd& whole, const std::vector<int>& slots, int anchor,
                    int head)
      : S_(whole) {
    for (std::size_t i = 0; i < slots.size(); ++i)
      blocks_[slots[i]] = static_cast<Eigen::Index>(6 + 3 * i);
    poses_[anchor] = 0;
    poses_[head] = whole.rows() - 6;
  }
  [[nodiscard]] bool HasPose(int node) const { return poses_.contains(node); }
  [[nodiscard]] bool HasBlock(int slot) const { return blocks_.contains(slot); }
  [[nodiscard]] const Eigen::MatrixXd& S() const { return S_; }
  [[nodiscard]] Eigen::Index RowOf(int node) const { return poses_.at(node); }
  [[nodiscard]] Eigen::Index RowOfBlock(int slot) const { return blocks_.at(slot); }

  void Place(const ArrowStretch& stretch) {
    constexpr int kNodes = ArrowLeaf::kNodes;
    if (HasPose(stretch.middle * kNodes)) return;
    Rows ends;
    Append(ends, RowOf(stretch.end * kNodes), 6);
    if (stretch.has_begin) Append(ends, RowOf(stretch.first * kNodes), 6);
    const auto with_blocks = [&](const std::vector<int>& slots) {
      Rows rows = ends;
      for (const int slot : slots)
        Append(rows, RowOfBlock(slot), 3);
      return rows;
    };
    for (auto block = stretch.blocks.rbegin(); block != stretch.blocks.rend(); ++block) {
      const Rows z = with_blocks(block->slots);
      const Eigen::Map<const Eigen::MatrixXd> W(block->W.data(), 3,
                                                static_cast<Eigen::Index>(z.size()));
      const Eigen::Index row = Add(block->L, W, z);
      blocks_[block->slot] = row;
    }
    poses_[stretch.middle * kNodes] = Add(stretch.conditional, with_blocks(stretch.middle_slots));
  }
  /// All poses inside a leaf from its end down to `node`.
  void WalkInto(const ArrowLeaf& leaf, int node) {
    for (int at = leaf.head() - 1; at >= node && at > leaf.anchor(); --at) {
      if (HasPose(at)) continue;
      Rows z;
      Append(z, RowOf(at + 1), 6);
      Append(z, RowOf(leaf.anchor()), 6);
      for (const int slot : leaf.slots())
        Append(z, RowOfBlock(slot), 3);
      const ArrowConditional& conditional = leaf.Interior(at);
      z.resize(static_cast<std::size_t>(conditional.columns()));
      poses_[at] = Add(conditional, z);
    }
  }

 private:
  Eigen::Index Add(const ArrowConditional& conditional, const Rows& z) {
    const Eigen::Map<const Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor>> W(
        conditional.W.data(), 6, conditional.columns());
    return Add(Eigen::Map<const NavCovariance>(conditional.L.data()), W, z);
  }
  /// Adds what was eliminated, given what `z` names in its order. With L'x = d + e - W z, e white:
  /// Cov(x, all) = -L^-T W Cov(z, all).
  Eigen::Index Add(const Eigen::MatrixXd& L, const Eigen::MatrixXd& W, const Rows& z) {
    const Eigen::Index rows = L.rows(), n = S_.rows();
    const auto Lt = L.transpose().triangularView<Eigen::Upper>();
    Eigen::MatrixXd with_all = Eigen::MatrixXd::Zero(rows, n);
    for (std::size_t i = 0; i < z.size(); ++i)
      with_all.noalias() -= W.col(static_cast<Eigen::Index>(i)) * S_.row(z[i]);
    with_all = Lt.solve(with_all).eval();
    Eigen::MatrixXd through_z = Eigen::MatrixXd::Zero(rows, rows);
    for (std::size_t i = 0; i < z.size(); ++i)
      through_z += with_all.col(z[i]) * W.col(static_cast<Eigen::Index>(i)).transpose();
    const Eigen::MatrixXd inverse = Lt.solve(Eigen::MatrixXd::Identity(rows, rows));
    S_.conservativeResize(n + rows, n + rows);
    S_.bottomLeftCorner(rows, n) = with_all;
    S_.topRightCorner(n, rows) = with_all.transpose();
    S_.bottomRightCorner(rows, rows) =
        inverse * inverse.transpose() - Lt.solve(through_z.transpose().eval());
    return n;
  }

  Eigen::MatrixXd S_;
  std::map<int, Eigen::Index> poses_;   ///< first row, by node
  std::map<int, Eigen::Index> blocks_;  ///< likewise, by slot
};

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

}  // namespace

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
    Append(from, descent.RowOf(node), 6);
  Append(to, 0, static_cast<Eigen::Index>(from.size()));
  auto size = static_cast<Eigen::Index>(from.size());
  for (const int slot : variables.slots) {
    if (estimates.IsSolved(slot)) {
      Append(from, descent.RowOfBlock(slot), 3);
      Append(to, size, 3);
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
    Append(rows, static_cast<Eigen::Index>(6 + 3 * i), 3);
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
