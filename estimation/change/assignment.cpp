// SPDX-License-Identifier: MIT
#include "estimation/change/assignment.hpp"

#include <algorithm>
#include <limits>

namespace limpet {
namespace {

/// Potentials and matching of the Hungarian method; index 0 is a sentinel, rows and columns count
/// from 1.
class Hungarian {
 public:
  Hungarian(const std::vector<std::vector<double>>& cost, double alone)
      : cost_(cost),
        alone_(alone),
        rows_(cost.size()),
        // One private column per row stands for "alone", so that a complete assignment exists.
        columns_((cost.empty() ? 0 : cost.front().size()) + cost.size()),
        row_potential_(rows_ + 1),
        column_potential_(columns_ + 1),
        row_of_(columns_ + 1),
        way_(columns_ + 1) {}

  std::vector<int> Solve() {
    for (std::size_t row = 1; row <= rows_; ++row) {
      Augment(row);
    }
    const std::size_t real_columns = columns_ - rows_;
    std::vector<int> column_of(rows_, -1);
    for (std::size_t column = 1; column <= real_columns; ++column) {
      const std::size_t row = row_of_[column];
      if (row != 0 && cost_[row - 1][column - 1] <= alone_) {
        column_of[row - 1] = static_cast<int>(column) - 1;
      }
    }
    return column_of;
  }

 private:
  [[nodiscard]] double Cost(std::size_t row, std::size_t column) const {
    const std::size_t real_columns = columns_ - rows_;
    const bool is_alone = column > real_columns;
    // A pairing beyond `alone` is worth exactly as much as staying alone, and is undone in Solve.
    return is_alone ? alone_ : std::min(cost_[row - 1][column - 1], alone_);
  }

  void Augment(std::size_t row) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    std::vector<double> slack(columns_ + 1, kInfinity);
    std::vector<bool> is_used(columns_ + 1, false);
    row_of_[0] = row;
    std::size_t column = 0;
    do {
      is_used[column] = true;
      const std::size_t from = row_of_[column];
      double step = kInfinity;
      std::size_t next = 0;
      for (std::size_t j = 1; j <= columns_; ++j) {
        if (is_used[j]) continue;
        const double reduced = Cost(from, j) - row_potential_[from] - column_potential_[j];
        if (reduced < slack[j]) {
          slack[j] = reduced;
          way_[j] = column;
        }
        if (slack[j] < step) {
          step = slack[j];
          next = j;
        }
      }
      for (std::size_t j = 0; j <= columns_; ++j) {
        if (is_used[j]) {
          row_potential_[row_of_[j]] += step;
          column_potential_[j] -= step;
        } else {
          slack[j] -= step;
        }
      }
      column = next;
    } while (row_of_[column] != 0);
    while (column != 0) {
      const std::size_t before = way_[column];
      row_of_[column] = row_of_[before];
      column = before;
    }
  }

  const std::vector<std::vector<double>>& cost_;
  double alone_;
  std::size_t rows_;
  std::size_t columns_;
  std::vector<double> row_potential_;
  std::vector<double> column_potential_;
  std::vector<std::size_t> row_of_;
  std::vector<std::size_t> way_;
};

}  // namespace

std::vector<int> AssignOneToOne(const std::vector<std::vector<double>>& cost, double alone) {
  return Hungarian(cost, alone).Solve();
}

}  // namespace limpet
