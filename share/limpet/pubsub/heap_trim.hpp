// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <malloc.h>

namespace limpet {

/// Gives freed memory back to the system. What a burst has left lies between small things that
/// stay: the allocator alone would keep it.
class HeapTrim {
 public:
  /// To be called twice a second; `writes`: taken since the start.
  void Look(std::uint64_t writes) {
    const std::uint64_t lately = writes - writes_;
    writes_ = writes;
    if (++looks_ % kLooksToTrim != 0) {
      return;
    }
    const std::size_t spare = mallinfo2().fordblks;
    if (spare > kMostSpare || (lately < kCalm && spare > kSpare)) {
      malloc_trim(kSpare / 4);
    }
  }

 private:
  static constexpr std::uint64_t kLooksToTrim = 4;
  static constexpr std::uint64_t kCalm = 1000;  ///< writes between looks: fewer, and it is over
  static constexpr std::size_t kSpare = std::size_t{2} << 20;       ///< kept for what comes next
  static constexpr std::size_t kMostSpare = std::size_t{32} << 20;  ///< also amid a burst

  std::uint64_t writes_ = 0;
  std::uint64_t looks_ = 0;
};

}  // namespace limpet
