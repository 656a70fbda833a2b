// SPDX-License-Identifier: MIT
#include "estimation/smoothing/arrow_root.hpp"

#include <algorithm>
#include <map>

#include <Eigen/Cholesky>

namespace limpet {
namespace {

constexpr double kUnknownInformation = 1e-8;  // that holds what nothing observes
constexpr double kUnknownVariance = 1e6;      // from which on a direction counts as not observed

}  // namespace

struct ArrowRoot::Prior {
  std::vector<int> slots;                  ///< in the order of their columns
  std::vector<std::optional<int>> places;  ///< of the slots that are in it
  Eigen::LLT<Eigen::MatrixXd> llt;
  Eigen::VectorXd mean;                      ///< absolute
  std::map<Block, Eigen::MatrixXd> columns;  ///< of the covariance, computed when asked
  // Of the last Solve: z = (anchor, the leaf's blocks), then the head.
  std::vector<Block> blocks;
  Eigen::MatrixXd z_columns;                  ///< of the prior's covariance
  Eigen::MatrixXd z_covariance, information;  ///< of z in the prior
  Eigen::LLT<Eigen::MatrixXd> joint;          ///< of the information of (z, head)
  NavCovariance head_covariance;
  mutable Eigen::MatrixXd posterior;  ///< covariance of (z, head); empty until it is asked for
  bool has_head = false;

  [[nodiscard]] const Eigen::MatrixXd& Posterior() const {
    if (posterior.size() == 0) {
      const Eigen::Index n = joint.rows();
      posterior = joint.solve(Eigen::MatrixXd::Identity(n, n));
    }
    return posterior;
  }

  [[nodiscard]] int First(Block block) const {
    return block ? 6 + 3 * *places[AsIndex(*block)] : 0;
  }
  static int Width(Block block) { return block ? 3 : 6; }
};

ArrowRoot::ArrowRoot() : prior_(std::make_unique<Prior>()) {}
ArrowRoot::~ArrowRoot() = default;
ArrowRoot::ArrowRoot(ArrowRoot&&) noexcept = default;
ArrowRoot& ArrowRoot::operator=(ArrowRoot&&) noexcept = default;

const std::vector<int>& ArrowRoot::slots() const { return prior_->slots; }

void ArrowRoot::SetPrior(const ArrowMessage& message, const std::vector<int>& slots,
                         const NavVector& anchor, const std::vector<double>& border) {
  const int n = message.size();
  Eigen::MatrixXd A = Eigen::Map<const Eigen::MatrixXd>(message.A.data(), n, n);
  A.diagonal().array() += kUnknownInformation;
  auto prior = std::make_unique<Prior>();
  prior->llt.compute(A);  // reads the lower triangle
  prior->mean = prior->llt.solve(Eigen::Map<const Eigen::VectorXd>(message.g.data(), n));
  prior->mean.head<6>() += anchor;
  prior->slots = slots;
  prior->places.assign(border.size() / 3, std::nullopt);
  for (std::size_t place = 0; place < slots.size(); ++place) {
    prior->places[AsIndex(slots[place])] = static_cast<int>(place);
    const Eigen::Map<const Eigen::Vector3d> from(&border[AsIndex(3 * slots[place])]);
    prior->mean.segment<3>(static_cast<Eigen::Index>(6 + 3 * place)) += from;
  }
  prior_ = std::move(prior);
}

const Eigen::MatrixXd& ArrowRoot::PriorColumns(Block block) const {
  const auto found = prior_->columns.find(block);
  if (found != prior_->columns.end()) {
    return found->second;
  }
  Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(prior_->mean.size(), Prior::Width(block));
  unit.middleRows(prior_->First(block), Prior::Width(block)).setIdentity();
  return prior_->columns[block] = prior_->llt.solve(unit);
}

void ArrowRoot::SelectPrior(const std::vector<Block>& blocks, Eigen::Index size) {
  Prior& p = *prior_;
  if (blocks == p.blocks && p.z_columns.rows() == p.mean.size()) return;
  p.blocks = blocks;
  p.z_columns.resize(p.mean.size(), size);
  Eigen::Index column = 0;
  for (const Block& block : blocks) {
    p.z_columns.middleCols(column, Prior::Width(block)) = PriorColumns(block);
    column += Prior::Width(block);
  }
  Eigen::MatrixXd& covariance = p.z_covariance;
  covariance.resize(size, size);
  Eigen::Index row = 0;
  for (const Block& block : blocks) {
    covariance.middleRows(row, Prior::Width(block)) =
        p.z_columns.middleRows(p.First(block), Prior::Width(block));
    row += Prior::Width(block);
  }
  p.information = covariance.llt().solve(Eigen::MatrixXd::Identity(size, size));
}

void ArrowRoot::Solve(const ArrowLeaf& leaf, const ArrowMessage& message) {
  Prior& p = *prior_;
  std::vector<Block> blocks{std::nullopt};
  blocks.insert(blocks.end(), leaf.slots().begin(), leaf.slots().end());
  const auto size = static_cast<Eigen::Index>(6 + 3 * leaf.slots().size());
  SelectPrior(blocks, size);
  // Changes count from where the leaf is linearised; the prior's mean is moved there.
  Eigen::VectorXd prior_change(size), linearised(size);
  linearised.head<6>() = leaf.x_anchor();
  for (Eigen::Index i = 6; i < size; ++i)
    linearised(i) = leaf.linearised()[static_cast<std::size_t>((i - 6) / 3)]((i - 6) % 3);
  Eigen::Index row = 0;
  for (const Block& block : blocks) {
    prior_change.segment(row, Prior::Width(block)) =
        p.mean.segment(p.First(block), Prior::Width(block));
    row += Prior::Width(block);
  }
  prior_change -= linearised;

  p.has_head = leaf.head() != leaf.anchor();
  const Eigen::Index n = size + (p.has_head ? 6 : 0);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd g = Eigen::VectorXd::Zero(n);
  A.topLeftCorner(size, size) = p.information;
  g.head(size) = p.information * prior_change;
  const int m = message.size();
  const Eigen::Map<const Eigen::MatrixXd> from(message.A.data(), m, m);
  const Eigen::Map<const Eigen::VectorXd> from_g(message.g.data(), m);
  A.topLeftCorner(size, size) += from.bottomRightCorner(size, size);
  g.head(size) += from_g.tail(size);
  if (p.has_head) {
    // The leaf has the head first; here it is last, so its row block is the leaf's column block.
    A.bottomRightCorner<6, 6>() = from.topLeftCorner<6, 6>();
    A.diagonal().tail<6>().array() += kUnknownInformation;
    A.bottomLeftCorner(6, size) = from.bottomLeftCorner(size, 6).transpose();
    g.tail<6>() = from_g.head<6>();
  }
  p.joint.compute(A);
  const Eigen::VectorXd change = p.joint.solve(g);
  p.posterior.resize(0, 0);
  if (p.has_head) {
    // The last in order: its own corner of the factor is all that its covariance takes.
    const NavCovariance L = p.joint.matrixLLT().bottomRightCorner<6, 6>();
    const NavCovariance inverse =
        L.triangularView<Eigen::Lower>().solve(NavCovariance::Identity().eval());
    p.head_covariance = inverse.transpose() * inverse;
  } else {
    p.head_covariance = p.Posterior().topLeftCorner<6, 6>();
  }
  held_.clear();
  for (int i = 0; i < 6; ++i) {
    if (p.head_covariance(i, i) > kUnknownVariance) held_.push_back(i);
  }
  anchor_ = leaf.x_anchor() + change.head<6>();
  head_ = p.has_head ? NavVector(leaf.x_head() + change.tail<6>()) : anchor_;
  const Eigen::VectorXd moved = p.information * (change.head(size) - prior_change);
  const Eigen::VectorXd all = p.mean + p.z_columns * moved;
  border_.assign(all.data() + 6, all.data() + all.size());
}

Eigen::MatrixXd ArrowRoot::Covariance(const std::vector<int>& slots) const {
  const Prior& p = *prior_;
  const Eigen::Index size = p.information.rows();
  if (slots.empty()) {
    return p.head_covariance;
  }
  const auto columns = static_cast<Eigen::Index>(6 + 3 * slots.size());
  // Of (z, head) with the blocks: a block depends on z alone, by G.
  std::vector<Eigen::MatrixXd> gains;
  for (const int slot : slots) {
    gains.emplace_back(p.z_columns.middleRows(p.First(slot), 3) * p.information);
  }
  const Eigen::MatrixXd& posterior = p.Posterior();
  const Eigen::Index head = p.has_head ? posterior.rows() - 6 : 0;
  const Eigen::MatrixXd prior_less_posterior = p.z_covariance - posterior.topLeftCorner(size, size);
  Eigen::MatrixXd joint(columns, columns);
  joint.topLeftCorner<6, 6>() = p.head_covariance;
  for (std::size_t a = 0; a < slots.size(); ++a) {
    const auto first = static_cast<Eigen::Index>(6 + 3 * a);
    joint.block(first, 0, 3, 6) = gains[a] * posterior.block(0, head, size, 6);
    joint.block(0, first, 6, 3) = joint.block(first, 0, 3, 6).transpose();
    const Eigen::MatrixXd reduced = gains[a] * prior_less_posterior;
    for (std::size_t b = 0; b <= a; ++b) {
      const auto second = static_cast<Eigen::Index>(6 + 3 * b);
      joint.block(first, second, 3, 3) =
          PriorColumns(slots[b]).middleRows(p.First(slots[a]), 3) - reduced * gains[b].transpose();
      joint.block(second, first, 3, 3) = joint.block(first, second, 3, 3).transpose().eval();
    }
  }
  return joint;
}

Eigen::MatrixXd ArrowRoot::WholeCovariance() const {
  const Prior& p = *prior_;
  const Eigen::Index n = p.mean.size(), size = p.information.rows();
  const Eigen::MatrixXd& posterior = p.Posterior();
  // Anchor and border depend on the leaf, and on its head, through z alone. What z itself comes to
  // is known as it stands: the difference of the two, of which the prior may know nothing, is not.
  const Eigen::MatrixXd gain = p.z_columns * p.information;
  Eigen::MatrixXd whole(n + 6, n + 6);
  whole.topLeftCorner(n, n) =
      p.llt.solve(Eigen::MatrixXd::Identity(n, n)) -
      gain * (p.z_covariance - posterior.topLeftCorner(size, size)) * gain.transpose();
  std::vector<Eigen::Index> z;
  for (const Block& block : p.blocks) {
    for (int i = 0; i < Prior::Width(block); ++i)
      z.push_back(p.First(block) + i);
  }
  const Eigen::Index head = p.has_head ? size : 0;
  Eigen::MatrixXd z_whole(size, n + 6);
  z_whole.leftCols(n) = posterior.topLeftCorner(size, size) * gain.transpose();
  z_whole(Eigen::all, z) = posterior.topLeftCorner(size, size);
  z_whole.rightCols(6) = posterior.block(0, head, size, 6);
  Eigen::MatrixXd head_whole(6, n + 6);
  head_whole.leftCols(n) = posterior.block(head, 0, 6, size) * gain.transpose();
  head_whole(Eigen::all, z) = posterior.block(head, 0, 6, size);
  head_whole.rightCols(6) = p.head_covariance;
  whole.bottomRows(6) = head_whole;
  whole.rightCols(6) = head_whole.transpose();
  whole(z, Eigen::all) = z_whole;
  whole(Eigen::all, z) = z_whole.transpose();
  return whole;
}

}  // namespace limpet
