// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/core/units.hpp"
#include "limpet/vehicle/thruster_layout.hpp"

namespace limpet {

/// What stands between a vehicle and a pilot that has fallen silent: a thruster command is in force
/// for `limit` after it was heard, by the clock of who hears it; then all thrusters rest. Commands
/// that no pilot means (not finite, beyond full thrust) are refused and do not count as heard.
class ThrusterWatchdog {
 public:
  static constexpr Seconds kLimit{1.0};

  explicit ThrusterWatchdog(Seconds limit = kLimit) : limit_(limit) {}

  /// Takes normalised thrusts, each in [-1, 1], heard at `now`. False, and counted, if refused.
  bool Hear(const ThrusterVector& command, Seconds now);
  /// Tells it the time, now and then: a clock that was set back must not make a command young.
  void KeepUp(Seconds now);
  /// What is in force at `time`: the last command, or zero.
  [[nodiscard]] ThrusterVector At(Seconds time) const;
  /// True if a command was heard, and all of them are older than the limit.
  [[nodiscard]] bool IsStale(Seconds time) const;
  /// Time since the last command was heard; absent if none was.
  [[nodiscard]] std::optional<Seconds> Age(Seconds time) const;
  [[nodiscard]] int refused() const { return refused_; }

 private:
  Seconds limit_;
  ThrusterVector command_ = ThrusterVector::Zero();
  std::optional<Seconds> heard_;
  int refused_ = 0;
};

}  // namespace limpet
