// SPDX-License-Identifier: MIT
#include "limpet/core/clock.hpp"

#include <chrono>

namespace limpet {
namespace {

template <class Clock>
Seconds SinceEpoch() {
  return Seconds(std::chrono::duration<double>(Clock::now().time_since_epoch()).count());
}

}  // namespace

Seconds UnixTime() { return SinceEpoch<std::chrono::system_clock>(); }
Seconds SteadyTime() { return SinceEpoch<std::chrono::steady_clock>(); }
Seconds MoosTime(double warp) { return UnixTime() * warp; }

}  // namespace limpet
