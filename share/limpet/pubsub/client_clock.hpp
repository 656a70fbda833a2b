// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "limpet/core/long_ago.hpp"
#include "limpet/core/units.hpp"
#include "limpet/wire/wire_message.hpp"

namespace limpet {

/// What a broker of ours says of its host in the welcome. Its name is not that of the host alone:
/// a stock client that finds its own host's name stops following the broker's clock and goes by the
/// wall clock, also when that is set (docs/adr/0014). Behind it, for our clients: the machine and
/// the origin of its vehicle time.
[[nodiscard]] std::string HostWords(const std::string& host);

/// The broker's MOOS time as a client knows it: the time warp, and how far this process's clock is
/// off. On the broker's own machine that is known exactly and stays; from another it is measured,
/// and follows so slowly that time never goes back. Any thread may ask; one thread tells it what
/// the broker said.
class ClientClock {
 public:
  explicit ClientClock(double warp) : warp_(warp) {}

  [[nodiscard]] double warp() const { return warp_.load(std::memory_order_relaxed); }
  /// MOOS time by this process's clock alone: what hello and timing messages carry.
  [[nodiscard]] Seconds Own() const;
  /// The broker's MOOS time; never less than it was, once a broker has been heard.
  [[nodiscard]] Seconds Now() const;
  /// How far the broker's clock is ahead of Now() by its last echo (real time): what was not
  /// followed, because somebody has set that clock.
  [[nodiscard]] Seconds disagreement() const { return Seconds(disagreement_.load()); }

  /// Takes the broker's welcome. The first one sets the clock; a later one, after a lost
  /// connection, does not: what a vehicle reckons with must not jump. Tools that learn the warp
  /// follow every broker.
  void TakeWelcome(const WireMessage& welcome, bool learns_warp);
  /// Takes the echo of a timing message.
  void TakeEcho(const WireMessage& echo);

 private:
  std::atomic<double> warp_;
  std::atomic<double> skew_{0.0};  ///< broker's MOOS time less ours [s]
  std::atomic<double> disagreement_{0.0};
  mutable std::atomic<double> latest_{kLongAgo};  ///< that Now() has said
  bool corrects_ = false, is_set_ = false;
};

}  // namespace limpet
