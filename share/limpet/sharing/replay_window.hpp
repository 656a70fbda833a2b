// SPDX-License-Identifier: MIT
#pragma once

#include <bitset>
#include <cstdint>
#include <optional>

namespace limpet {

/// Which datagrams of one sender have been taken. A sender's epoch begins when it starts and only
/// goes forward; within an epoch each counter is good once, in any order, as long as it is less
/// than `kWidth` behind the highest.
class ReplayWindow {
 public:
  static constexpr std::size_t kWidth = 1024;

  enum class Verdict { kNew, kRepeated, kTooOld, kFormerEpoch };

  [[nodiscard]] Verdict Judge(std::uint64_t epoch, std::uint64_t counter) const {
    if (!top_ || epoch > epoch_) {
      return Verdict::kNew;
    }
    if (epoch < epoch_) {
      return Verdict::kFormerEpoch;
    }
    if (counter > *top_) {
      return Verdict::kNew;
    }
    const std::uint64_t behind = *top_ - counter;
    if (behind >= kWidth) {
      return Verdict::kTooOld;
    }
    return seen_[behind] ? Verdict::kRepeated : Verdict::kNew;
  }

  /// REQUIRES: Judge(epoch, counter) is kNew, and the datagram is authentic.
  void Take(std::uint64_t epoch, std::uint64_t counter) {
    if (!top_ || epoch > epoch_) {
      epoch_ = epoch;
      top_ = counter;
      seen_.reset();
    } else if (counter > *top_) {
      const std::uint64_t ahead = counter - *top_;
      seen_ = ahead < kWidth ? seen_ << ahead : std::bitset<kWidth>();
      top_ = counter;
    }
    seen_.set(*top_ - counter);
  }

  /// Everything up to `counter` of `epoch` counts as taken: what was noted before a restart.
  void Forget(std::uint64_t epoch, std::uint64_t counter) {
    epoch_ = epoch;
    top_ = counter;
    seen_.set();
  }
  [[nodiscard]] std::uint64_t epoch() const { return epoch_; }
  [[nodiscard]] std::optional<std::uint64_t> top() const { return top_; }

 private:
  std::uint64_t epoch_ = 0;
  std::optional<std::uint64_t> top_;
  std::bitset<kWidth> seen_;  ///< by distance behind top_
};

}  // namespace limpet
