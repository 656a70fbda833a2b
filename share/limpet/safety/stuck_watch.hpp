// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "limpet/core/units.hpp"

namespace limpet {

/// For how long a sensor has said the very same: noise and motion change what a sound one says.
template <std::size_t N>
class StuckWatch {
 public:
  void Hear(const std::array<double, N>& sample, Seconds now) {
    if (!last_ || *last_ != sample) {
      last_ = sample;
      since_ = now;
    }
    heard_ = now;
  }
  /// Up to the last sample: a sensor that is silent is not stuck. Absent before the first.
  [[nodiscard]] std::optional<double> duration() const {
    return last_ ? std::optional((heard_ - since_).value()) : std::nullopt;
  }

 private:
  std::optional<std::array<double, N>> last_;
  Seconds since_, heard_;
};

}  // namespace limpet
