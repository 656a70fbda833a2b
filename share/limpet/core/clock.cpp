// SPDX-License-Identifier: MIT
#include "limpet/core/clock.hpp"

#include <chrono>

#include <time.h>

namespace limpet {
namespace {

template <class Clock>
Seconds SinceEpoch() {
  return Seconds(std::chrono::duration<double>(Clock::now().time_since_epoch()).count());
}

}  // namespace

Seconds UnixTime() { return SinceEpoch<std::chrono::system_clock>(); }
Seconds SteadyTime() { return SinceEpoch<std::chrono::steady_clock>(); }
Seconds ThreadTime() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return Seconds(static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec));
}
Seconds MoosTime(double warp) { return UnixTime() * warp; }

}  // namespace limpet
