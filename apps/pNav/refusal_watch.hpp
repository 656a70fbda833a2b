// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

namespace limpet {

/// Share of one sensor's samples that was refused lately.
class RefusalWatch {
 public:
  /// A sample measured at `stamp` [s] has come, and was taken or not.
  void Note(double stamp, bool is_refused) {
    if (!std::isfinite(stamp)) return;
    const double kept = std::exp(-std::clamp(stamp - last_, 0.0, kLongestStep) / kMemory);
    last_ = stamp;
    all_ = kept * all_ + 1.0;
    refused_ = kept * refused_ + (is_refused ? 1.0 : 0.0);
  }
  /// Share of samples refused, to the thousandth, as NAV_STATE says it.
  [[nodiscard]] double share() const { return std::round(1e3 * refused_ / all_) / 1e3; }

 private:
  static constexpr double kMemory = 5.0;       // [s]
  static constexpr double kLongestStep = 1.0;  // [s] that a gap is worth
  double last_ = 0.0;
  double all_ = 5.0;  // a first sample that is refused is no storm
  double refused_ = 0.0;
};

}  // namespace limpet
