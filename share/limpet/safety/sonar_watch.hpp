// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/core/units.hpp"
#include "limpet/safety/stuck_watch.hpp"
#include "limpet/topics/sensors.hpp"

namespace limpet {

/// Whether the sonar that looks ahead is heard, and whether it repeats itself. Allocates nothing.
class SonarWatch {
 public:
  void Hear(const SonarPing& ping, Seconds now);
  /// When it was last heard; absent before.
  [[nodiscard]] std::optional<Seconds> heard() const { return heard_; }
  /// For how long it has said the very same echoes [s]. Pings without any are all alike in open
  /// water: those are never stuck. Absent before the first.
  [[nodiscard]] std::optional<double> stuck_for() const { return echoes_.duration(); }

 private:
  std::optional<Seconds> heard_;
  StuckWatch<3> echoes_;  ///< what sums up a ping
  double empty_pings_ = 0.0;
};

}  // namespace limpet
