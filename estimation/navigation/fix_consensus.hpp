// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "estimation/navigation/measurement_buffer.hpp"
#include "limpet/core/long_ago.hpp"

namespace limpet {

/// A fix held against dead reckoning.
struct HeldFix {
  PositionFix fix;
  int node = 0;                                     ///< of the chain, at its time
  Eigen::Vector2d off_W = Eigen::Vector2d::Zero();  ///< fix less dead reckoning [m]
};

/// Where dead reckoning and all that is known have the next fix, less dead reckoning [m].
struct FixPrediction {
  Eigen::Vector2d off_W = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance_W = Eigen::Matrix2d::Identity();
};

/// Which fixes of one stay at the surface are believed. Reflections put fixes metres off for
/// seconds and then elsewhere, while dead reckoning hardly drifts: fixes that lie alike against it
/// are a group. That group is believed whose fixes span the most time; one that the prediction at
/// the stay's begin allows has a lead. Which one it is may change while the stay lasts.
class FixConsensus {
 public:
  /// True if a stay begins with a fix at `t` [s]: the last one is long ago.
  [[nodiscard]] bool IsNewStay(double t) const;
  /// `prediction`: nothing if nothing tells where the vehicle is. `scale`: sigma of fixes over what
  /// they state, as far as that is known.
  void BeginStay(const std::optional<FixPrediction>& prediction, double scale = 1.0);

  struct Verdict {
    bool is_believed = false;
    bool has_changed_group = false;  ///< all fixes believed so far are not, and others are
  };
  /// The next fix. REQUIRES: a stay has begun.
  Verdict Add(const HeldFix& held);

  /// Fixes of this stay that are believed, by time.
  [[nodiscard]] const std::vector<HeldFix>& believed() const;
  /// Mean square of each axis by which they are off because another group may be the right one
  /// [m^2].
  [[nodiscard]] double DoubtVariance() const;
  [[nodiscard]] std::size_t refused() const { return added_ - believed().size(); }

 private:
  struct Group {
    std::vector<HeldFix> fixes;
    Eigen::Vector2d off_W;                           ///< of the latest fixes
    bool is_predicted = true;                        ///< the prediction allows it
    double support = 0.0;                            ///< [s]
    std::optional<std::size_t> last = std::nullopt;  ///< of its fixes among all of the stay
  };
  Group& GroupOf(const HeldFix& held);
  /// Notes the step from one fix to the next of the latest [m]; of wandering or noisy fixes, not of
  /// jumps.
  void NoteStep(const HeldFix& held);
  [[nodiscard]] bool IsAsPredicted(const HeldFix& held) const;
  [[nodiscard]] double SupportOf(const Group& group) const;
  [[nodiscard]] bool IsBetter(const Group& rival) const;

  std::optional<FixPrediction> prediction_;
  double scale_ = 1.0;
  std::deque<double> steps_;  ///< from fix to fix, of the latest [m]
  double usual_step_ = 0.0;   ///< their median
  Eigen::Vector2d last_off_W_ = Eigen::Vector2d::Zero();
  std::vector<Group> groups_;
  std::optional<std::size_t> believed_;  ///< of groups_
  std::size_t added_ = 0;                ///< fixes of this stay
  double last_t_ = kLongAgo;
};

}  // namespace limpet
