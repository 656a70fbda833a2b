// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "limpet/helm/behavior.hpp"
#include "limpet/helm/view_decision.hpp"
#include "limpet/helm/warning_book.hpp"

namespace limpet {

/// One decision variable's domain as the mission file gives it; course is a circle and has none.
struct MotionDomain {
  double speed_low = 0.0, speed_high = 1.0;    ///< [m/s]
  double depth_low = 0.0, depth_high = 100.0;  ///< [m]
};

/// What the helm asks of the vehicle now.
struct MotionDecision {
  std::optional<double> course;     ///< [rad]
  std::optional<double> speed;      ///< [m/s]
  std::optional<double> depth;      ///< [m]
  std::optional<double> turn_rate;  ///< feed-forward of the heaviest bidder on course [rad/s]
  std::vector<OwnedWarning> warnings;
  std::vector<BehaviorTurn> turns;  ///< of all running behaviors
  std::vector<std::string> active;  ///< names of behaviors that had an opinion

  /// Names of decision variables that nobody bid on, e.g. "course,depth"; "" if complete.
  [[nodiscard]] std::string Missing() const;
};

/// "How now": preferences over each variable, weighted, summed, maximised exactly.
[[nodiscard]] MotionDecision DecideMotion(std::span<const WeightedBehavior> behaviors,
                                          const VehicleState& state, const MotionDomain& domain);

}  // namespace limpet
