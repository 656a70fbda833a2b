// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/core/interval.hpp"

namespace limpet {

/// Round values of a range: steps of 1, 2 or 5 times a power of ten, at most about `count`.
[[nodiscard]] std::vector<double> TickMarks(const Interval& range, int count);

/// A tick's value in as few digits as it needs, with a true minus sign.
[[nodiscard]] std::string TickText(double value);

}  // namespace limpet
