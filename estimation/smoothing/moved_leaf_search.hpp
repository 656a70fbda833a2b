// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "estimation/smoothing/arrow_estimates.hpp"

namespace limpet {

/// A change since linearisation beyond which a leaf is linearised anew.
struct RelinearizeThresholds {
  double angle = 0.01;     ///< turn [rad]
  double distance = 0.05;  ///< of a landmark against the poses [m]
};

[[nodiscard]] inline bool Exceeds(const ArrowLeaf::Displacement& moved,
                                  const RelinearizeThresholds& thresholds) {
  return moved.angle > thresholds.angle || moved.distance > thresholds.distance;
}

/// Looks for leaves whose estimate has moved too far since they were linearised: from the newest
/// back, so many per update, passing over every stretch whose ends and landmarks have stayed where
/// the last search found them.
class MovedLeafSearch {
 public:
  explicit MovedLeafSearch(const RelinearizeThresholds& thresholds) : thresholds_(thresholds) {}

  void AddBorderVariable(int slot, const Eigen::Vector3d& start);
  /// The newest leaf has become full; `anchor`: estimate of the pose that it begins with.
  void AddLeaf(const NavVector& anchor);
  /// These leaves have changed and are visited whatever has moved.
  void Visit(int leaf) { visit_.insert(leaf); }
  /// The next update begins a search, whatever has moved.
  void RequestSearch() { is_due_ = true; }
  /// All leaves have been linearised at the estimate.
  void Restart(const ArrowChain& chain, const std::vector<double>& border);
  [[nodiscard]] bool is_under_way() const { return search_.has_value(); }
  /// Goes on with the search, or begins one where anything has moved: leaves to be linearised anew.
  [[nodiscard]] std::vector<int> Continue(const ArrowChain& chain, const ArrowEstimates& estimates);

 private:
  /// A search under way.
  struct Search {
    int at = 0;                 ///< anchor that it has come down to
    bool is_whole = false;      ///< visits all leaves
    bool has_at_moved = false;  ///< that anchor, since the last search
  };
  /// Where the search goes on after the newest leaf before `at`, and whether that leaf is the one
  /// to look at.
  struct Next {
    int anchor;
    bool is_leaf;
  };
  [[nodiscard]] Next Advance(const ArrowChain& chain, const ArrowEstimates& estimates);
  void Begin(int leaves);
  void ComeDownTo(int anchor, const ArrowEstimates& estimates);
  /// True if the search may pass over all of it: neither ends nor landmarks have moved.
  [[nodiscard]] bool IsUnmoved(const ArrowStretch& stretch, const ArrowEstimates& estimates) const;
  [[nodiscard]] bool HasMoved(int anchor, const ArrowEstimates& estimates) const;
  [[nodiscard]] bool NoteMovedLandmarks(const ArrowChain& chain, const ArrowEstimates& estimates);
  /// True if it has moved since the last search.
  bool NoteIfMoved(int slot, const ArrowChain& chain, const ArrowEstimates& estimates);

  RelinearizeThresholds thresholds_;
  std::optional<Search> search_;
  bool is_due_ = false;
  int updates_since_whole_ = 0;
  std::set<int> visit_;
  std::vector<bool> has_border_moved_;  ///< by slot, since the last search
  std::vector<double> border_;          ///< estimates as of the last search, three per slot
  std::vector<NavVector> anchors_;      ///< estimates as of the last search
};

}  // namespace limpet
