// SPDX-License-Identifier: MIT
// Covariances of any variables, from the smoother's own factors: down from the root, anchor by
// anchor, and into the leaves that hold a pose that is asked for.
#include <algorithm>
#include <functional>

#include "estimation/smoothing/arrow_smoother.hpp"
#include "limpet/core/require.hpp"

namespace limpet {
namespace {

using Rows = std::vector<Eigen::Index>;

constexpr double kUnknownBlock = 1e8;  // [m^2] of a block that no update has seen yet

void Append(Rows& rows, Eigen::Index first, Eigen::Index count) {
  for (Eigen::Index i = 0; i < count; ++i)
    rows.push_back(first + i);
}

/// Joint covariance of (the pose where the descent is, the border, a pose inside a leaf, poses
/// that are kept).
class Descent {
 public:
  static constexpr Eigen::Index kHere = 0, kBorder = 6;

  /// `whole`: of (last anchor, border, head).
  Descent(const Eigen::MatrixXd& whole, std::size_t kept)
      : inside_(whole.rows() - 6), end_(whole.rows()) {
    S_ = Eigen::MatrixXd::Zero(end_ + 6 * static_cast<Eigen::Index>(kept),
                               end_ + 6 * static_cast<Eigen::Index>(kept));
    S_.topLeftCorner(end_, end_) = whole;
  }
  [[nodiscard]] Eigen::Index inside() const { return inside_; }
  [[nodiscard]] Eigen::Index border() const { return inside_ - kBorder; }
  [[nodiscard]] const Eigen::MatrixXd& S() const { return S_; }

  /// The pose at `to` becomes that of the rows `from`.
  void Copy(Eigen::Index from, Eigen::Index to) {
    const Eigen::MatrixXd with_all = S_.middleRows(from, 6);
    const NavCovariance own = S_.block<6, 6>(from, from);
    Set(to, with_all, own);
  }
  void Keep(Eigen::Index from) {
    Copy(from, end_);
    end_ += 6;
  }
  /// The pose at `to` becomes the eliminated one, given what `z` names in its order. With
  /// L'x = d + e - W z, e white:  Cov(x, all) = -L^-T W Cov(z, all).
  void Place(const ArrowConditional& conditional, const Rows& z, Eigen::Index to) {
    const Eigen::Map<const Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor>> W(
        conditional.W.data(), 6, conditional.columns());
    const Eigen::Map<const NavCovariance> L(conditional.L.data());
    const auto Lt = L.transpose().triangularView<Eigen::Upper>();
    Eigen::MatrixXd with_all = Eigen::MatrixXd::Zero(6, S_.cols());
    for (Eigen::Index i = 0; i < W.cols(); ++i) {
      with_all.leftCols(end_).noalias() -=
          W.col(i) * S_.row(z[static_cast<std::size_t>(i)]).head(end_);
    }
    with_all = Lt.solve(with_all).eval();
    NavCovariance own = Lt.solve(NavCovariance(Lt.solve(NavCovariance::Identity()).transpose()));
    NavCovariance through_z = NavCovariance::Zero();
    for (Eigen::Index i = 0; i < W.cols(); ++i) {
      through_z += with_all.col(z[static_cast<std::size_t>(i)]) * W.col(i).transpose();
    }
    own -= Lt.solve(NavCovariance(through_z.transpose()));
    Set(to, with_all, own);
  }

  /// Keeps the poses that are wanted inside a leaf whose end is inside, its anchor here.
  void WalkInto(const ArrowLeaf& leaf, std::vector<int>::iterator& next,
                std::vector<int>::iterator end) {
    Rows z;
    Append(z, inside_, 6);
    Append(z, kHere, 6);
    for (const int slot : leaf.slots())
      Append(z, kBorder + 3 * slot, 3);
    for (int node = leaf.head() - 1; next != end && *next > leaf.anchor(); --node) {
      Place(leaf.Interior(node), z, inside_);
      if (*next != node) continue;
      Keep(inside_);
      ++next;
    }
  }

 private:
  void Set(Eigen::Index at, const Eigen::MatrixXd& with_all, const NavCovariance& own) {
    S_.middleRows(at, 6) = with_all;
    S_.middleCols(at, 6) = with_all.transpose();
    S_.block<6, 6>(at, at) = own;
  }
  Eigen::Index inside_, end_;
  Eigen::MatrixXd S_;
};

}  // namespace

JointCovariance ArrowSmoother::CovarianceOf(const std::vector<int>& nodes,
                                            const std::vector<int>& landmarks) const {
  std::vector<int> wanted(nodes);
  std::ranges::sort(wanted, std::greater<>());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  LIMPET_REQUIRE(
      wanted.empty() || (has_begun_ && wanted.back() >= 0 && wanted.front() <= open_.head()),
      "nodes that an update has seen");
  const Eigen::MatrixXd whole = root_.WholeCovariance();
  Descent descent(whole, wanted.size());
  Rows trunk_rows;
  Append(trunk_rows, 0, 6 + descent.border());
  auto next = wanted.begin();
  for (int leaf = static_cast<int>(leaves_.size()); next != wanted.end(); --leaf) {
    const bool is_open = leaf == static_cast<int>(leaves_.size());
    const ArrowLeaf& of = is_open ? open_ : leaves_[AsIndex(leaf)];
    if (!is_open) {
      descent.Copy(Descent::kHere, descent.inside());
      descent.Place(trunk_.conditional(leaf), trunk_rows, Descent::kHere);
    } else if (*next == of.head()) {
      descent.Keep(descent.inside());
      ++next;
    }
    if (next != wanted.end() && *next > of.anchor()) descent.WalkInto(of, next, wanted.end());
    if (next != wanted.end() && *next == of.anchor()) {
      descent.Keep(Descent::kHere);
      ++next;
    }
  }
  // Gather what was asked for, in its order; blocks that nobody knows stay so.
  Rows from, to;
  for (const int node : nodes) {
    const auto at = std::ranges::lower_bound(wanted, node, std::greater<>()) - wanted.begin();
    Append(from, whole.rows() + 6 * at, 6);
  }
  Append(to, 0, static_cast<Eigen::Index>(from.size()));
  Eigen::Index size = static_cast<Eigen::Index>(from.size());
  for (const int slot : landmarks) {
    if (is_solved_[AsIndex(slot)]) {
      Append(from, Descent::kBorder + 3 * slot, 3);
      Append(to, size, 3);
    }
    size += 3;
  }
  JointCovariance joint = kUnknownBlock * JointCovariance::Identity(size, size);
  joint(to, to) = descent.S()(from, from);
  return joint;
}

}  // namespace limpet
