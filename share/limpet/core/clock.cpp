// SPDX-License-Identifier: MIT
#include "limpet/core/clock.hpp"

#include <charconv>
#include <chrono>
#include <cstdlib>
#include <fstream>

#include <time.h>

namespace limpet {
namespace {

constexpr double kNanosecond = 1e-9;
constexpr std::int64_t kFarthest = 4'000'000'000'000'000'000;  ///< [ns] sums stay in range

template <class Clock>
std::int64_t NanosecondsOf() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now().time_since_epoch())
      .count();
}

std::int64_t SteadyNs() { return NanosecondsOf<std::chrono::steady_clock>(); }

ClockOrigin FindOrigin() {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): nobody changes the environment of a running process
  const char* text = std::getenv(kClockOriginVariable);
  if (const auto given = ParseClockOrigin(text != nullptr ? text : "")) {
    return *given;
  }
  return {NanosecondsOf<std::chrono::system_clock>() - SteadyNs()};
}

}  // namespace

Seconds UnixTime() {
  return Seconds(kNanosecond * static_cast<double>(NanosecondsOf<std::chrono::system_clock>()));
}
Seconds SteadyTime() { return Seconds(kNanosecond * static_cast<double>(SteadyNs())); }
Seconds ThreadTime() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return Seconds(static_cast<double>(now.tv_sec) + kNanosecond * static_cast<double>(now.tv_nsec));
}

ClockOrigin OwnClockOrigin() {
  static const ClockOrigin origin = FindOrigin();
  return origin;
}

std::string TextOf(ClockOrigin origin) { return std::to_string(origin.ns); }

std::optional<ClockOrigin> ParseClockOrigin(std::string_view text) {
  ClockOrigin origin;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, origin.ns);
  const bool is_whole = error == std::errc() && rest == end && !text.empty();
  return is_whole && std::abs(origin.ns) < kFarthest ? std::optional(origin) : std::nullopt;
}

std::string BootId() {
  static const std::string id = [] {
    std::string word;
    std::ifstream("/proc/sys/kernel/random/boot_id") >> word;
    return word;
  }();
  return id;
}

Seconds VehicleTime() {
  return Seconds(kNanosecond * static_cast<double>(OwnClockOrigin().ns + SteadyNs()));
}
Seconds MoosTime(double warp) { return VehicleTime() * warp; }

}  // namespace limpet
