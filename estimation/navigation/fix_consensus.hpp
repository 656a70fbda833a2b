// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "estimation/navigation/measurement_buffer.hpp"
#include "limpet/core/long_ago.hpp"
#include "limpet/core/units.hpp"

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
  /// `prediction`: nothing if nothing tells where the vehicle is.
  void BeginStay(const std::optional<FixPrediction>& prediction);

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
  [[nodiscard]] bool IsAsPredicted(const HeldFix& held) const;
  [[nodiscard]] double SupportOf(const Group& group) const;
  [[nodiscard]] bool IsBetter(const Group& rival) const;

  std::optional<FixPrediction> prediction_;
  std::vector<Group> groups_;
  std::optional<std::size_t> believed_;  ///< of groups_
  std::size_t added_ = 0;                ///< fixes of this stay
  double last_t_ = kLongAgo;
};

/// What fixes state of their error: its sigma, and for how long it stays about the same.
struct FixError {
  double sd = 0.0;  ///< of north as of east [m]
  Seconds correlation;
};

/// What the spread of a stay's fixes says of the part of their error that wanders, over what they
/// state of all of it. What differs from one fix to the next is no part of that: a stay's mean has
/// next to nothing of it. An error that wanders shows less of itself in a stay shorter than
/// its correlation than in a long one; that share is made up for. `residuals_W`: of fixes in order,
/// over `span`, against the smoothed track [m].
[[nodiscard]] double SpreadScale(const std::vector<Eigen::Vector2d>& residuals_W, Seconds span,
                                 const FixError& stated);

}  // namespace limpet
