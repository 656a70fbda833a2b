// SPDX-License-Identifier: MIT
#include "limpet/figures/tick_marks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace limpet {

std::vector<double> TickMarks(const Interval& range, int count) {
  const auto [low, high] = range;
  if (!(high > low) || count < 1) return {};
  const double rough = (high - low) / count;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double ratio = rough / power;
  const double step = power * (ratio <= 1.0 ? 1.0 : ratio <= 2.0 ? 2.0 : ratio <= 5.0 ? 5.0 : 10.0);
  std::vector<double> ticks;
  const auto last = static_cast<long>(std::floor(high / step + 1e-9));
  for (auto k = static_cast<long>(std::ceil(low / step - 1e-9)); k <= last; ++k) {
    ticks.push_back(static_cast<double>(k) * step);
  }
  return ticks;
}

std::string TickText(double value) {
  const std::string text = fmt::format("{:g}", std::abs(value) < 1e-12 ? 0.0 : std::abs(value));
  return value < -1e-12 ? "\u2212" + text : text;
}

}  // namespace limpet
