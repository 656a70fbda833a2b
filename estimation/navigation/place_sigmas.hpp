// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "estimation/smoothing/smoother.hpp"
#include "limpet/objects/frame.hpp"

namespace limpet {

/// How sure the chain is of its places: absolutely, and against the pass beside each, which tells
/// whether there is a gap between what two passes saw. A fix that is off, or a heading, moves both
/// passes alike and opens no gap.
class PlaceSigmas {
 public:
  /// Poses so near to one another look at the same ground [m].
  static constexpr double kSameGround = 6.0;
  /// Poses with so much way between them are of two passes [m].
  static constexpr double kOtherPass = 12.0;

  /// Notes the chain's next pose: its time [s] and place in W [m] as known now.
  void Note(double t, const Eigen::Vector2d& p_W);
  [[nodiscard]] int noted() const { return static_cast<int>(times_.size()); }
  [[nodiscard]] double TimeOf(int node) const { return times_[static_cast<std::size_t>(node)]; }
  /// 1-sigma of a node that has been noted and that the smoother's last update knew.
  [[nodiscard]] PlaceSigma Of(int node, const Smoother& smoother) const;
  /// The node of an earlier pass that is nearest to this one; nothing if none is near.
  [[nodiscard]] std::optional<int> NodeBeside(int node) const;

 private:
  std::vector<double> times_, way_;  ///< [s]; from the first pose on [m]
  std::vector<Eigen::Vector2d> places_;
};

}  // namespace limpet
