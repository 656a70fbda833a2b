// SPDX-License-Identifier: MIT
#include "limpet/vehicle/thruster_watchdog.hpp"

#include <algorithm>

namespace limpet {
namespace {

/// Full thrust, as a sender's arithmetic may have rounded it.
constexpr double kFullThrust = 1.0 + 1e-6;

}  // namespace

bool ThrusterWatchdog::Hear(const ThrusterVector& command, Seconds now) {
  // Written so that NaN fails.
  if (!(command.array().abs() <= kFullThrust).all()) {
    ++refused_;
    return false;
  }
  command_ = command;
  heard_ = now;
  return true;
}

void ThrusterWatchdog::KeepUp(Seconds now) {
  if (heard_) {
    heard_ = std::min(*heard_, now);
  }
}

std::optional<Seconds> ThrusterWatchdog::Age(Seconds time) const {
  return heard_ ? std::optional<Seconds>(time - *heard_) : std::nullopt;
}

bool ThrusterWatchdog::IsStale(Seconds time) const { return heard_ && time - *heard_ > limit_; }

ThrusterVector ThrusterWatchdog::At(Seconds time) const {
  return IsStale(time) ? ThrusterVector(ThrusterVector::Zero()) : command_;
}

}  // namespace limpet
