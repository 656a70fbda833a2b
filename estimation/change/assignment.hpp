// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace limpet {

/// One-to-one assignment of rows to columns with the least total cost, where leaving a row alone
/// costs `alone`; entries above `alone` are never used. Returns each row's column, or -1.
/// Hungarian method, O(n^3). REQUIRES: all rows of equal length.
[[nodiscard]] std::vector<int> AssignOneToOne(const std::vector<std::vector<double>>& cost,
                                              double alone);

}  // namespace limpet
