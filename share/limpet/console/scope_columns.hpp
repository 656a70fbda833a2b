// SPDX-License-Identifier: MIT
// How a variable looks in a table.
#pragma once

#include <cstddef>
#include <vector>

#include "limpet/console/frame.hpp"
#include "limpet/console/variable_table.hpp"

namespace limpet {

/// What a table of variables needs to know beside its rows.
struct ScopeMoment {
  Seconds now;        ///< MOOS time
  double warp = 1.0;  ///< MOOS seconds per second
  bool keeps_utf8 = true;
};

/// Widths of the columns of a table of variables; the value takes what is left.
class ScopeColumns {
 public:
  /// Fits the rows into `width` columns; kAnyWidth cuts nothing.
  ScopeColumns(const std::vector<const VariableRow*>& rows, std::size_t width, bool keeps_utf8);

  [[nodiscard]] FrameLine Head() const;
  [[nodiscard]] FrameLine Row(const VariableRow& row, const ScopeMoment& moment) const;

 private:
  [[nodiscard]] std::size_t ValueWidth() const;

  std::size_t width_;
  std::size_t name_ = 8;
  std::size_t source_ = 6;
  std::size_t community_ = 0;  ///< 0: not shown, all are of one
  bool has_count_ = false;
};

}  // namespace limpet
