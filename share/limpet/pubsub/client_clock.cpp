// SPDX-License-Identifier: MIT
#include "limpet/pubsub/client_clock.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <unistd.h>

#include "limpet/core/clock.hpp"

namespace limpet {
namespace {

constexpr double kOldestEcho = 1.0;  ///< that still tells the clock [s], real time
constexpr double kMostWarp = 1000.0;

std::string HostName() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

/// The warp of a broker whose clock shows `time`, if both machines know the date to some days.
std::optional<double> WarpOf(double time) {
  const double warp = std::round(1e3 * time / UnixTime().value()) / 1e3;
  return warp >= 1.0 && warp <= kMostWarp ? std::optional(warp) : std::nullopt;
}

}  // namespace

Seconds ClientClock::Own() const { return MoosTime(warp()); }

void ClientClock::TakeWelcome(const WireMessage& welcome, bool learns_warp) {
  corrects_ = welcome.source_aux != "hostname=" + HostName();
  double skew = welcome.number;
  if (learns_warp) {
    warp_ = WarpOf(welcome.time).value_or(warp());
    skew = welcome.time - Own().value();  // the hello's time was of another warp
  }
  skew_ = corrects_ ? skew : 0.0;
}

void ClientClock::TakeEcho(const WireMessage& echo) {
  const double received = Own().value();
  if (!corrects_ || received - echo.time > kOldestEcho * warp()) {
    return;  // an old one waited somewhere, perhaps for a new connection: that says nothing of
             // clocks
  }
  const double measured = echo.number - 0.5 * (echo.time + received);
  const double skew = skew_.load();
  skew_ = skew == 0.0 ? measured : 0.9 * skew + 0.1 * measured;
}

}  // namespace limpet
