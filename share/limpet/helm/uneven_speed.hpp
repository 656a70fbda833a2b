// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/helm/motion_domain.hpp"
#include "limpet/helm/motion_table.hpp"

namespace limpet {

/// What is wanted of the speed, and the part of the behavior's weight that it gets.
struct WantedSpeed {
  double speed = 0.0;       ///< [m/s]
  double slow_value = 0.7;  ///< at 0.1 m/s
  double share = 0.5;
};

/// A preference over speed that falls slowly towards slow and steeply towards fast, by straight
/// lines between points of the domain: MOOS-IvP's `zaic_spd`. From nothing at the slowest to
/// `slow_value` at 0.1 m/s, to 1 at the speed that is wanted, to 0.2 at 0.4 m/s more, to nothing at
/// the fastest.
class UnevenSpeed {
 public:
  /// Valid until the next call; null if the domain has no speed. Allocates at the first only.
  const MotionTable* Around(const WantedSpeed& wanted, const MotionDomain& domain);

 private:
  std::optional<MotionTable> table_;
};

}  // namespace limpet
