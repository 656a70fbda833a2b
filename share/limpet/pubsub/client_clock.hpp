// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

#include "limpet/core/units.hpp"
#include "limpet/wire/wire_message.hpp"

namespace limpet {

/// The broker's MOOS time as a client knows it: the time warp, and how far this machine's clock is
/// off. Any thread may ask; one thread tells it what the broker said.
class ClientClock {
 public:
  explicit ClientClock(double warp) : warp_(warp) {}

  [[nodiscard]] double warp() const { return warp_.load(std::memory_order_relaxed); }
  /// MOOS time by this machine's clock alone: what hello and timing messages carry.
  [[nodiscard]] Seconds Own() const;
  /// The broker's MOOS time.
  [[nodiscard]] Seconds Now() const { return Own() + Seconds(skew_.load()); }

  /// Takes the broker's welcome. On one host there is nothing to correct.
  void TakeWelcome(const WireMessage& welcome, bool learns_warp);
  /// Takes the echo of a timing message.
  void TakeEcho(const WireMessage& echo);

 private:
  std::atomic<double> warp_;
  std::atomic<double> skew_{0.0};  ///< broker's MOOS time less ours [s]
  bool corrects_ = false;
};

}  // namespace limpet
