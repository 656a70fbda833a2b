// SPDX-License-Identifier: MIT
#include "limpet/pubsub/client_clock.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/clock.hpp"
#include "limpet/core/host_name.hpp"

namespace limpet {
namespace {

constexpr double kOldestEcho = 1.0;  ///< that still tells the clock [s], real time
constexpr double kMostWarp = 1000.0;
/// Farthest that one echo, of about a second, moves the clock [s], real time: time then runs a
/// tenth fast or slow, and never stands.
constexpr double kLargestStep = 0.1;
/// Two clocks of one machine agree better than that [s]; else they only share its name.
constexpr double kSameClock = 5.0;

/// The warp of a broker whose clock shows `time`, if both machines know the date to some days.
std::optional<double> WarpOf(double time) {
  const double warp = std::round(1e3 * time / VehicleTime().value()) / 1e3;
  return warp >= 1.0 && warp <= kMostWarp ? std::optional(warp) : std::nullopt;
}

/// Value of `key=` in comma-separated words.
std::string_view WordOf(std::string_view text, std::string_view key) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(','), text.size());
    const std::string_view word = text.substr(0, end);
    if (word.starts_with(key) && word.substr(key.size()).starts_with('=')) {
      return word.substr(key.size() + 1);
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return {};
}

/// How far the vehicle time of a broker on this machine is ahead of ours [s]; nothing if it is on
/// another one, or does not say.
std::optional<double> AheadOnThisMachine(std::string_view host_words) {
  const std::string here = BootId();
  const auto origin = ParseClockOrigin(WordOf(host_words, "origin"));
  if (!origin || here.empty() || WordOf(host_words, "boot") != here) {
    return std::nullopt;
  }
  return 1e-9 * static_cast<double>(origin->ns - OwnClockOrigin().ns);
}

}  // namespace

std::string HostWords(const std::string& host) {
  return "vehicle_time@" + host + ",boot=" + BootId() + ",origin=" + TextOf(OwnClockOrigin());
}

Seconds ClientClock::Own() const { return MoosTime(warp()); }

Seconds ClientClock::Now() const {
  const double now = Own().value() + skew_.load();
  double latest = latest_.load();
  while (now > latest && !latest_.compare_exchange_weak(latest, now)) {
  }
  return Seconds(std::max(now, latest));
}

void ClientClock::TakeWelcome(const WireMessage& welcome, bool learns_warp) {
  if (is_set_ && !learns_warp) {
    return;
  }
  is_set_ = true;
  double skew = welcome.number;
  if (learns_warp) {
    warp_ = WarpOf(welcome.time).value_or(warp());
    skew = welcome.time - Own().value();  // the hello's time was of another warp
  }
  const std::optional<double> ahead = AheadOnThisMachine(welcome.source_aux);
  const bool is_shared =
      ahead && std::abs(welcome.time / warp() - *ahead - VehicleTime().value()) < kSameClock;
  corrects_ = !is_shared && welcome.source_aux != "hostname=" + HostName().value_or("");
  skew_ = is_shared ? *ahead * warp() : corrects_ ? skew : 0.0;
  latest_ = kLongAgo;
}

void ClientClock::TakeEcho(const WireMessage& echo) {
  const double received = Own().value();
  if (received - echo.time > kOldestEcho * warp()) {
    return;  // an old one waited somewhere, perhaps for a new connection: that says nothing of
             // clocks
  }
  const double measured = echo.number - 0.5 * (echo.time + received);
  const double skew = skew_.load();
  const double most = kLargestStep * warp();
  const double step = corrects_ ? std::clamp(0.1 * (measured - skew), -most, most) : 0.0;
  skew_ = skew + step;
  disagreement_ = (measured - skew - step) / warp();
}

}  // namespace limpet
