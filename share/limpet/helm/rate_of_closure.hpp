// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/helm/motion_domain.hpp"
#include "limpet/helm/motion_table.hpp"

namespace limpet {

/// Where a place lies, and how fast it is to come nearer.
struct WantedClosure {
  double bearing = 0.0;  ///< [rad]
  double speed = 0.0;    ///< [m/s]
};

/// A preference over course and speed together for coming nearer to a place at a wanted rate, and,
/// a quarter as much, for not going aside fast: MOOS-IvP's `ipf_type = roc`. To come nearer faster
/// costs half of what slower does. From 0 at the worst of the domain's points to 1 at the best.
class RateOfClosure {
 public:
  /// Valid until the next call; null if the domain lacks course or speed. Allocates at the first
  /// only.
  const MotionTable* Toward(const WantedClosure& wanted, const MotionDomain& domain);

 private:
  std::optional<MotionTable> table_;
};

}  // namespace limpet
