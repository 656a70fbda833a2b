// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace limpet {

/// Cost of a pair that the assignment may not choose.
inline constexpr double kImpossibleCost = 1e6;

/// One-to-one assignment of rows to columns with the least total cost, where leaving a row without
/// a column costs `unassigned` [Kuhn 1955]. Entries of `costs` at or above it are never chosen.
/// Returns the column of each row, if it has one. Deterministic: of equal totals, the one found
/// first.
[[nodiscard]] std::vector<std::optional<int>> AssignOneToOne(const Eigen::MatrixXd& costs,
                                                             double unassigned);

}  // namespace limpet
