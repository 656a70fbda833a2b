// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "limpet/core/require.hpp"

namespace limpet {

/// What stands beside the cells of a tile where a grid keeps nothing of its own there.
struct NoTileNote {};

/// A value for each cell of a grid, kept in square tiles. A tile comes into being when one of its
/// cells is first written; until then its cells read as blank. So memory, and whatever goes through
/// all tiles, is bounded by what has been written, not by how large the grid is. `Note` is kept
/// once per tile.
template <class Cell, class Note = NoTileNote>
class TileGrid {
 public:
  static constexpr int kEdge = 32;  ///< [cells]

  struct Tile {
    int row = 0, column = 0;  ///< of its first cell
    Note note{};
    std::array<Cell, std::size_t{kEdge} * kEdge> cells{};
  };

  /// REQUIRES: one row and one column or more.
  TileGrid(int rows, int columns)
      : rows_(rows), columns_(columns), tile_columns_(TilesOver(columns)) {
    LIMPET_REQUIRE(rows > 0 && columns > 0, "a grid has cells");
    tiles_.resize(static_cast<std::size_t>(TilesOver(rows)) *
                  static_cast<std::size_t>(tile_columns_));
  }

  TileGrid(const TileGrid& other)
      : rows_(other.rows_), columns_(other.columns_), tile_columns_(other.tile_columns_) {
    for (const auto& tile : other.tiles_)
      tiles_.push_back(tile ? std::make_unique<Tile>(*tile) : nullptr);
  }
  TileGrid& operator=(const TileGrid& other) {
    *this = TileGrid(other);
    return *this;
  }
  TileGrid(TileGrid&&) noexcept = default;
  TileGrid& operator=(TileGrid&&) noexcept = default;
  ~TileGrid() = default;

  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int columns() const { return columns_; }

  [[nodiscard]] const Cell& At(int row, int column) const {
    const Tile* tile = tiles_[Slot(row, column)].get();
    return tile == nullptr ? kBlank : tile->cells[Within(row, column)];
  }
  /// The cell to be written to.
  [[nodiscard]] Cell& Write(int row, int column) {
    return CellOf(TileAt(row, column), row, column);
  }
  [[nodiscard]] static Cell& CellOf(Tile& tile, int row, int column) {
    return tile.cells[Within(row, column)];
  }
  /// The tile that holds a cell, made if there was none.
  [[nodiscard]] Tile& TileAt(int row, int column) {
    std::unique_ptr<Tile>& tile = tiles_[Slot(row, column)];
    if (!tile) {
      tile = std::make_unique<Tile>();
      tile->row = row / kEdge * kEdge;
      tile->column = column / kEdge * kEdge;
    }
    return *tile;
  }
  /// Null where nothing was written.
  [[nodiscard]] const Tile* FindTile(int row, int column) const {
    return tiles_[Slot(row, column)].get();
  }
  [[nodiscard]] Tile* FindTile(int row, int column) { return tiles_[Slot(row, column)].get(); }

  /// Calls visit(tile) for each tile that there is, row by row of tiles.
  template <class Visit>
  void EachTile(Visit visit) const {
    for (const auto& tile : tiles_) {
      if (tile) visit(std::as_const(*tile));
    }
  }
  template <class Visit>
  void EachTile(Visit visit) {
    for (const auto& tile : tiles_) {
      if (tile) visit(*tile);
    }
  }
  /// Calls visit(row, column, cell) for each cell of a tile that lies in the grid.
  template <class AnyTile, class Visit>
  void EachCell(AnyTile& tile, Visit visit) const {
    const int rows = std::min(kEdge, rows_ - tile.row);
    const int columns = std::min(kEdge, columns_ - tile.column);
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        visit(tile.row + row, tile.column + column, tile.cells[Within(row, column)]);
      }
    }
  }
  /// Calls `visit` with row, column and cell of each cell of all tiles, tile by tile.
  template <class Visit>
  void EachCell(Visit visit) const {
    EachTile([&](const Tile& tile) { EachCell(tile, visit); });
  }

 private:
  static constexpr Cell kBlank{};

  static int TilesOver(int cells) { return (cells + kEdge - 1) / kEdge; }
  [[nodiscard]] std::size_t Slot(int row, int column) const {
    return static_cast<std::size_t>(row / kEdge * tile_columns_ + column / kEdge);
  }
  [[nodiscard]] static std::size_t Within(int row, int column) {
    return static_cast<std::size_t>(row % kEdge * kEdge + column % kEdge);
  }

  int rows_, columns_, tile_columns_;
  std::vector<std::unique_ptr<Tile>> tiles_;
};

}  // namespace limpet
