// SPDX-License-Identifier: MIT
#include "estimation/smoothing/covariance_descent.hpp"

#include <algorithm>

namespace limpet {

void AppendRows(std::vector<Eigen::Index>& rows, Eigen::Index first, Eigen::Index count) {
  for (Eigen::Index i = 0; i < count; ++i)
    rows.push_back(first + i);
}

CovarianceDescent::CovarianceDescent(const Eigen::MatrixXd& whole, const std::vector<int>& slots,
                                     int anchor, int head)
    : S_(whole), n_(whole.rows()) {
  for (std::size_t i = 0; i < slots.size(); ++i)
    blocks_[slots[i]] = static_cast<Eigen::Index>(6 + 3 * i);
  poses_[anchor] = 0;
  poses_[head] = whole.rows() - 6;
}

CovarianceDescent CovarianceDescent::At(const ArrowStretch& stretch) const {
  CovarianceDescent less;
  Rows rows;
  const auto take_pose = [&](int leaf) {
    const int node = leaf * ArrowLeaf::kNodes;
    less.poses_[node] = static_cast<Eigen::Index>(rows.size());
    AppendRows(rows, RowOf(node), 6);
  };
  take_pose(stretch.end);
  if (stretch.has_begin) take_pose(stretch.first);
  for (const int slot : stretch.slots) {
    less.blocks_[slot] = static_cast<Eigen::Index>(rows.size());
    AppendRows(rows, RowOfBlock(slot), 3);
  }
  less.n_ = static_cast<Eigen::Index>(rows.size());
  const auto eliminated = static_cast<Eigen::Index>(6 + 3 * stretch.blocks.size());
  less.S_.resize(less.n_ + eliminated, less.n_ + eliminated);
  less.S_.topLeftCorner(less.n_, less.n_) = S_(rows, rows);
  return less;
}

void CovarianceDescent::Place(const ArrowStretch& stretch) {
  constexpr int kNodes = ArrowLeaf::kNodes;
  if (HasPose(stretch.middle * kNodes)) return;
  Rows ends;
  AppendRows(ends, RowOf(stretch.end * kNodes), 6);
  if (stretch.has_begin) AppendRows(ends, RowOf(stretch.first * kNodes), 6);
  const auto with_blocks = [&](const std::vector<int>& slots) {
    Rows rows = ends;
    for (const int slot : slots)
      AppendRows(rows, RowOfBlock(slot), 3);
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

void CovarianceDescent::WalkInto(const ArrowLeaf& leaf, int node) {
  for (int at = leaf.head() - 1; at >= node && at > leaf.anchor(); --at) {
    if (HasPose(at)) continue;
    Rows z;
    AppendRows(z, RowOf(at + 1), 6);
    AppendRows(z, RowOf(leaf.anchor()), 6);
    for (const int slot : leaf.slots())
      AppendRows(z, RowOfBlock(slot), 3);
    const ArrowConditional& conditional = leaf.Interior(at);
    z.resize(static_cast<std::size_t>(conditional.columns()));
    poses_[at] = Add(conditional, z);
  }
}

Eigen::Index CovarianceDescent::Add(const ArrowConditional& conditional, const Rows& z) {
  const Eigen::Map<const Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor>> W(
      conditional.W.data(), 6, conditional.columns());
  return Add(Eigen::Map<const NavCovariance>(conditional.L.data()), W, z);
}

Eigen::Index CovarianceDescent::Add(const Eigen::MatrixXd& L, const Eigen::MatrixXd& W,
                                    const Rows& z) {
  // With L'x = d + e - W z, e white: Cov(x, all) = -L^-T W Cov(z, all).
  const Eigen::Index rows = L.rows(), n = n_;
  const auto Lt = L.transpose().triangularView<Eigen::Upper>();
  Eigen::MatrixXd all_with = Eigen::MatrixXd::Zero(n, rows);
  for (std::size_t i = 0; i < z.size(); ++i) {
    for (Eigen::Index k = 0; k < rows; ++k)
      all_with.col(k) -= W(k, static_cast<Eigen::Index>(i)) * S_.col(z[i]).head(n);
  }
  const Eigen::MatrixXd with_all = Lt.solve(all_with.transpose());
  Eigen::MatrixXd through_z = Eigen::MatrixXd::Zero(rows, rows);
  for (std::size_t i = 0; i < z.size(); ++i)
    through_z += with_all.col(z[i]) * W.col(static_cast<Eigen::Index>(i)).transpose();
  const Eigen::MatrixXd inverse = Lt.solve(Eigen::MatrixXd::Identity(rows, rows));
  n_ = n + rows;
  if (n_ > S_.rows()) {
    const Eigen::Index room = std::max(n_, n + n / 2);
    S_.conservativeResize(room, room);
  }
  S_.block(n, 0, rows, n) = with_all;
  S_.block(0, n, n, rows) = with_all.transpose();
  S_.block(n, n, rows, rows) =
      inverse * inverse.transpose() - Lt.solve(through_z.transpose().eval());
  return n;
}

}  // namespace limpet
