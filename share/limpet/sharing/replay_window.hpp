// SPDX-License-Identifier: MIT
#pragma once

#include <bitset>
#include <cstdint>
#include <optional>

namespace limpet {

/// Which datagrams of one sender, since its start, have been taken: each counter is good once, in
/// any order, as long as it is less than `kWidth` behind the highest.
class ReplayWindow {
 public:
  static constexpr std::size_t kWidth = 1024;

  [[nodiscard]] bool IsNew(std::uint64_t counter) const {
    if (!top_ || counter > *top_) {
      return true;
    }
    const std::uint64_t behind = *top_ - counter;
    return behind < kWidth && !seen_[behind];
  }

  /// REQUIRES: IsNew(counter), and the datagram is authentic.
  void Take(std::uint64_t counter) {
    if (!top_ || counter > *top_) {
      const std::uint64_t ahead = top_ ? counter - *top_ : kWidth;
      seen_ = ahead < kWidth ? seen_ << ahead : std::bitset<kWidth>();
      top_ = counter;
    }
    seen_.set(*top_ - counter);
  }

 private:
  std::optional<std::uint64_t> top_;
  std::bitset<kWidth> seen_;  ///< by distance behind top_
};

}  // namespace limpet
