// SPDX-License-Identifier: MIT
#include "limpet/survey/wanted_cells.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace limpet {
namespace {

enum class Side { kInside, kOutside, kMixed };

/// Where a disc lies with regard to the ground that is to be seen.
Side SideOf(const SurveyShape& shape, const PlanePoint& centre, double radius) {
  const double depth = shape.outline().Depth(centre);
  if (depth <= -radius) return Side::kOutside;
  bool is_mixed = depth < radius;
  for (const SimplePolygon& zone : shape.zones()) {
    const double in_zone = zone.Depth(centre);
    if (in_zone >= radius) return Side::kOutside;
    is_mixed = is_mixed || in_zone > -radius;
  }
  return is_mixed ? Side::kMixed : Side::kInside;
}

}  // namespace

WantedCells::WantedCells(const SurveyShape& shape, const GridFrame& frame,
                         const SamplePoint& sample)
    : tile_columns_((frame.columns + kEdge - 1) / kEdge) {
  constexpr double kSlack = 0.01;  // of rounding [m]
  const double edge = kEdge * frame.cell_m, radius = edge / std::numbers::sqrt2 + kSlack;
  for (int first_row = 0; first_row < frame.rows; first_row += kEdge) {
    for (int first_column = 0; first_column < frame.columns; first_column += kEdge) {
      const int rows = std::min(kEdge, frame.rows - first_row);
      const int columns = std::min(kEdge, frame.columns - first_column);
      const PlanePoint centre{frame.north_min + first_row * frame.cell_m + 0.5 * edge,
                              frame.east_min + first_column * frame.cell_m + 0.5 * edge};
      const Side side = SideOf(shape, centre, radius);
      if (side != Side::kMixed) {
        tiles_.push_back(side == Side::kInside ? kAll : kNone);
        count_ += side == Side::kInside ? static_cast<std::size_t>(rows * columns) : 0;
        continue;
      }
      tiles_.push_back(static_cast<std::int32_t>(mixed_.size()));
      std::array<std::uint32_t, kEdge>& bits = mixed_.emplace_back();
      for (int row = 0; row < rows; ++row) {
        std::uint32_t& line = bits[static_cast<std::size_t>(row)];
        for (int column = 0; column < columns; ++column) {
          const bool is_wanted = shape.Wants(sample(first_row + row, first_column + column));
          line |= static_cast<std::uint32_t>(is_wanted) << static_cast<unsigned>(column);
        }
        count_ += static_cast<std::size_t>(std::popcount(line));
      }
    }
  }
}

WantedCells::WantedCells(const GridFrame& frame)
    : tile_columns_((frame.columns + kEdge - 1) / kEdge),
      tiles_(static_cast<std::size_t>((frame.rows + kEdge - 1) / kEdge * tile_columns_), kAll),
      count_(static_cast<std::size_t>(frame.rows) * static_cast<std::size_t>(frame.columns)) {}

void WantedCells::Drop(int row, int column) {
  if (!Has(row, column)) return;
  std::int32_t& tile = tiles_[Tile(row, column)];
  if (tile == kAll) {
    tile = static_cast<std::int32_t>(mixed_.size());
    mixed_.emplace_back().fill(~std::uint32_t{0});
  }
  mixed_[static_cast<std::size_t>(tile)][static_cast<std::size_t>(row % kEdge)] &=
      ~(std::uint32_t{1} << static_cast<unsigned>(column % kEdge));
  --count_;
}

}  // namespace limpet
