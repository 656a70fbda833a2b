// SPDX-License-Identifier: MIT
#include "estimation/matching/assignment.hpp"

#include <limits>

namespace limpet {

std::vector<std::optional<int>> AssignOneToOne(const Eigen::MatrixXd& costs, double unassigned) {
  // Hungarian method [Kuhn 1955] with potentials; each row has a column of its own that means
  // "none".
  const auto rows = static_cast<int>(costs.rows()), real = static_cast<int>(costs.cols());
  const int columns = real + rows;
  const auto cost = [&](int row, int column) {
    return column < real ? std::min(costs(row, column), unassigned) : unassigned;
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<double> u(static_cast<std::size_t>(rows) + 1),
      v(static_cast<std::size_t>(columns) + 1);
  std::vector<int> row_of(static_cast<std::size_t>(columns) + 1, 0);
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  for (int row = 1; row <= rows; ++row) {
    std::vector<double> least(at(columns) + 1, kInfinity);
    std::vector<int> from(at(columns) + 1, 0);
    std::vector<bool> is_done(at(columns) + 1, false);
    int column = 0;
    row_of[0] = row;
    do {
      is_done[at(column)] = true;
      const int i = row_of[at(column)];
      double delta = kInfinity;
      int next = 0;
      for (int j = 1; j <= columns; ++j) {
        if (is_done[at(j)]) continue;
        const double reduced = cost(i - 1, j - 1) - u[at(i)] - v[at(j)];
        if (reduced < least[at(j)]) least[at(j)] = reduced, from[at(j)] = column;
        if (least[at(j)] < delta) delta = least[at(j)], next = j;
      }
      for (int j = 0; j <= columns; ++j) {
        if (is_done[at(j)]) {
          u[at(row_of[at(j)])] += delta, v[at(j)] -= delta;
        } else {
          least[at(j)] -= delta;
        }
      }
      column = next;
    } while (row_of[at(column)] != 0);
    for (; column != 0; column = from[at(column)]) {
      row_of[at(column)] = row_of[at(from[at(column)])];
    }
  }
  std::vector<std::optional<int>> result(at(rows));
  for (int j = 1; j <= real; ++j) {
    const int i = row_of[at(j)];
    if (i > 0 && costs(i - 1, j - 1) < unassigned) {
      result[at(i - 1)] = j - 1;
    }
  }
  return result;
}

}  // namespace limpet
