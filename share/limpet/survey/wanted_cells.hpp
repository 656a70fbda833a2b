// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "limpet/survey/survey_shape.hpp"
#include "limpet/topics/mapping.hpp"

namespace limpet {

/// Which cells of a survey grid are to be seen. Tiles of cells that lie wholly inside or outside
/// are known as such by their distance to the borders; cell by cell only those at a border are.
class WantedCells {
 public:
  /// The sample point of a cell, by row and column. It lies in the cell.
  using SamplePoint = std::function<PlanePoint(int row, int column)>;

  WantedCells(const SurveyShape& shape, const GridFrame& frame, const SamplePoint& sample);
  /// All of them.
  explicit WantedCells(const GridFrame& frame);
  /// That cell is not to be seen, after all.
  void Drop(int row, int column);

  [[nodiscard]] bool Has(int row, int column) const {
    const std::int32_t tile = tiles_[Tile(row, column)];
    if (tile < 0) return tile == kAll;
    const std::uint32_t bits =
        mixed_[static_cast<std::size_t>(tile)][static_cast<std::size_t>(row % kEdge)];
    return (bits >> static_cast<unsigned>(column % kEdge) & 1U) != 0;
  }
  /// How many there are.
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  static constexpr int kEdge = 32;  ///< of a tile [cells]
  static constexpr std::int32_t kNone = -1, kAll = -2;

  [[nodiscard]] std::size_t Tile(int row, int column) const {
    return static_cast<std::size_t>(row / kEdge * tile_columns_ + column / kEdge);
  }

  int tile_columns_;
  std::vector<std::int32_t> tiles_;                      ///< kNone, kAll, or which of mixed_
  std::vector<std::array<std::uint32_t, kEdge>> mixed_;  ///< a bit per cell
  std::size_t count_ = 0;
};

}  // namespace limpet
