// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "estimation/smoothing/arrow_tree.hpp"
#include "estimation/smoothing/border_status.hpp"
#include "estimation/smoothing/chain_graph.hpp"

namespace limpet {

/// The factor graph cut into leaves: full ones in a tree, the newest still growing. Knows which
/// leaf depends on which border variable, and which leaf a changed term makes old.
/// `border`, throughout: estimates of all border variables, three per slot.
class ArrowChain {
 public:
  /// `most_at_hand`: landmarks and sizes; where there are more, those that are not needed rest.
  explicit ArrowChain(int most_at_hand) : most_at_hand_(most_at_hand) {}

  int AddNode(const NavVector& x, std::optional<Term> step);
  TermId AddTerm(int node, Term term);
  int AddBorderVariable(const Eigen::Vector3d& start, BorderKind kind);
  /// No node to come depends on these sensor errors.
  void Close(int slot);
  /// The next poses may depend on these or be asked about with them: they do not go to rest now.
  void Need(std::span<const int> slots);
  /// Brings back to the border what rests.
  void Wake(const std::vector<int>& slots);
  /// Those of the variables that rest.
  [[nodiscard]] std::vector<int> Resting(std::span<const int> slots) const;
  /// Notes that terms of the node change: the full leaf that is to be linearised anew, if it is in
  /// one.
  [[nodiscard]] std::optional<int> NoteChange(int node);

  [[nodiscard]] bool has_begun() const { return has_begun_; }
  void Begin();
  /// Takes the next node into the newest leaf; true if that made it full: it is in the tree then.
  /// REQUIRES: has_begun() and a node beyond the newest leaf's head.
  [[nodiscard]] bool ExtendOpenLeaf(const std::vector<double>& border);
  /// The newest leaf anew, where the graph's nodes are but for its anchor, up to its head.
  void RebuildOpenLeafIfDirty(const std::vector<double>& border);
  /// The newest leaf anew at these poses, from its anchor on, up to the last node.
  void RelinearizeOpenLeaf(const std::vector<NavVector>& poses, const std::vector<double>& border);
  /// A full leaf anew at these poses. The tree has to be refreshed.
  void RelinearizeLeaf(int leaf, const std::vector<NavVector>& poses,
                       const std::vector<double>& border);
  /// All leaves anew where the graph's nodes are.
  void RelinearizeAll(const std::vector<double>& border);

  [[nodiscard]] const ChainGraph& graph() const { return graph_; }
  [[nodiscard]] ChainGraph& graph() { return graph_; }
  [[nodiscard]] const ArrowTree& tree() const { return tree_; }
  [[nodiscard]] ArrowTree& tree() { return tree_; }
  [[nodiscard]] const ArrowLeaf& open_leaf() const { return open_; }
  [[nodiscard]] bool is_open_leaf_dirty() const { return is_open_dirty_; }
  /// All that is known of the newest leaf, with the terms of its head.
  [[nodiscard]] ArrowMessage OpenMessage(const std::vector<double>& border) {
    return open_.WithHeadTerms(graph_, border);
  }
  [[nodiscard]] const std::vector<BorderStatus>& border_status() const { return status_; }
  [[nodiscard]] const BorderStatus& status(int slot) const { return status_[AsIndex(slot)]; }
  [[nodiscard]] bool IsClosed(int slot) const { return status(slot).phase == BorderPhase::kClosed; }
  /// The leaf that the node is in, the newest too; an anchor belongs to the leaf that it begins.
  [[nodiscard]] int LeafOf(int node) const;

 private:
  /// Any of these.
  [[nodiscard]] bool HaveLeftBorder(std::span<const int> slots) const {
    return std::ranges::any_of(
        slots, [this](int slot) { return status(slot).phase != BorderPhase::kOpen; });
  }
  void FileOpenLeaf(const std::vector<double>& border);
  /// Sensor errors that nothing depends on from here on leave the border.
  void CloseWhatIsDue(const std::vector<double>& border);
  /// Landmarks and sizes that have not been needed for long leave it until they are.
  void RestWhatIsIdle(const std::vector<double>& border);
  /// For each slot whether a term or prior on it does not belong to a single variable of the
  /// border.
  [[nodiscard]] std::vector<bool> IsTiedInBorder() const;
  /// True if a variable that stays in the border has a term on it.
  [[nodiscard]] bool IsNamedByOthers(int slot) const;
  [[nodiscard]] ClosedBlock ClosedBlockOf(int slot, const std::vector<double>& border) const;

  ChainGraph graph_;
  std::vector<BorderStatus> status_;  ///< by slot
  ArrowTree tree_;                    ///< of the full leaves
  ArrowLeaf open_;                    ///< the newest
  int most_at_hand_;
  bool has_begun_ = false, is_open_dirty_ = false;
};

}  // namespace limpet
