// SPDX-License-Identifier: MIT
#include "estimation/smoothing/border_terms.hpp"

#include <array>
#include <optional>
#include <span>

namespace limpet {
namespace {

/// Variables in the order of their columns, which begin with the anchor's six.
class BorderColumns {
 public:
  BorderColumns(std::vector<int> slots, int slot_count)
      : slots_(std::move(slots)), positions_(AsIndex(slot_count)) {
    for (std::size_t i = 0; i < slots_.size(); ++i)
      positions_[AsIndex(slots_[i])] = static_cast<int>(i);
  }
  void Append(int slot) {
    if (positions_[AsIndex(slot)]) return;
    positions_[AsIndex(slot)] = static_cast<int>(slots_.size());
    slots_.push_back(slot);
  }
  [[nodiscard]] int Of(int slot) const { return 6 + 3 * *positions_[AsIndex(slot)]; }
  [[nodiscard]] const std::vector<int>& slots() const { return slots_; }

 private:
  std::vector<int> slots_;
  std::vector<std::optional<int>> positions_;  ///< by slot
};

void AddOwnTerms(int slot, const ChainGraph& graph, const BorderColumns& columns,
                 const std::vector<double>& border, const ArrowOrigin& origin,
                 ArrowMessage& message) {
  LinearTerm linear;
  for (const Term& term : graph.border(slot).terms) {
    LinearizeBorderTerm(term, border, origin, linear);
    std::array<JacobianBlock, kMostBorders> blocks;
    for (std::size_t i = 0; i < term.slots().size(); ++i)
      blocks[i] = {columns.Of(term.slots()[i]), 3, linear.J_border[i].data()};
    message.Add(linear, std::span(blocks).first(term.slots().size()));
  }
}

/// Linear, so it is exact wherever the border is linearised.
void AddJointPrior(const JointPrior& prior, const BorderColumns& columns, const ArrowOrigin& origin,
                   ArrowMessage& message) {
  Eigen::VectorXd off = -prior.mean();
  std::vector<int> rows;
  for (const int slot : prior.slots()) {
    for (int i = 0; i < 3; ++i) {
      off(static_cast<Eigen::Index>(rows.size())) += origin.border[AsIndex(3 * slot + i)];
      rows.push_back(columns.Of(slot) + i);
    }
  }
  const Eigen::MatrixXd& information = prior.information();
  const Eigen::VectorXd pull = information * off;
  for (std::size_t j = 0; j < rows.size(); ++j) {
    message.g[AsIndex(rows[j])] -= pull(static_cast<Eigen::Index>(j));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i] < rows[j]) continue;  // the message keeps its lower triangle
      message.at(rows[i], rows[j]) +=
          information(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }
  }
}

}  // namespace

void LinearizeBorderTerm(const Term& term, const std::vector<double>& border,
                         const ArrowOrigin& origin, LinearTerm& linear) {
  const std::span<const int> slots = term.slots();
  std::array<Eigen::Vector3d, kMostBorders> values;
  TermPoint at;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    values[i] = Eigen::Map<const Eigen::Vector3d>(&border[AsIndex(3 * slots[i])]);
    at.border[i] = &values[i];
  }
  term.Linearize(at, linear);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const Eigen::Vector3d change =
        values[i] - Eigen::Map<const Eigen::Vector3d>(&origin.border[AsIndex(3 * slots[i])]);
    linear.r.head(linear.rows) -= linear.J_border[i].topRows(linear.rows) * change;
  }
}

BorderInformation CollectBorderInformation(const ChainGraph& graph, const ArrowTree& tree,
                                           const std::vector<BorderStatus>& status,
                                           const std::vector<double>& border) {
  // The tree's variables, then those that no full leaf touches.
  BorderColumns columns(tree.whole().slots, graph.slot_count());
  for (int slot = 0; slot < graph.slot_count(); ++slot) {
    if (status[AsIndex(slot)].phase != BorderPhase::kClosed) columns.Append(slot);
  }
  ArrowMessage message = tree.whole().message;
  message.GrowBorder(3 * static_cast<int>(columns.slots().size()));
  for (const int slot : columns.slots())
    AddOwnTerms(slot, graph, columns, border, tree.origin, message);
  if (graph.joint_prior()) AddJointPrior(*graph.joint_prior(), columns, tree.origin, message);
  return {.message = std::move(message), .slots = columns.slots()};
}

}  // namespace limpet
