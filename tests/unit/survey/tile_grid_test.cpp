// SPDX-License-Identifier: MIT
#include "limpet/survey/tile_grid.hpp"

#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace limpet {
namespace {

struct Depth {
  int metres = 7;
};
using Depths = TileGrid<Depth, int>;

int TilesOf(const Depths& grid) {
  int tiles = 0;
  grid.EachTile([&tiles](const Depths::Tile&) { ++tiles; });
  return tiles;
}

TEST(TileGrid, ReadsAsBlankWhereNothingWasWrittenAndMakesNoTileForThat) {
  const Depths grid(4000, 4000);
  EXPECT_EQ(grid.At(3999, 3999).metres, 7);
  EXPECT_EQ(grid.FindTile(0, 0), nullptr);
  EXPECT_EQ(TilesOf(grid), 0);
}

TEST(TileGrid, KeepsWhatIsWrittenToACellAndNothingBesideIt) {
  Depths grid(100, 70);
  grid.Write(99, 69).metres = 12;
  EXPECT_EQ(grid.At(99, 69).metres, 12);
  EXPECT_EQ(grid.At(99, 68).metres, 7);
  EXPECT_EQ(grid.At(98, 69).metres, 7);
  EXPECT_EQ(TilesOf(grid), 1);
}

TEST(TileGrid, GoesThroughTheCellsOfATileAtTheEdgeThatLieInTheGrid) {
  Depths grid(40, 35);
  Depths::Tile& tile = grid.TileAt(39, 34);
  std::vector<std::pair<int, int>> cells;
  grid.EachCell(tile,
                [&cells](int row, int column, const Depth&) { cells.emplace_back(row, column); });
  ASSERT_EQ(cells.size(), 8U * 3U);
  EXPECT_EQ(cells.front(), std::pair(32, 32));
  EXPECT_EQ(cells.back(), std::pair(39, 34));
}

TEST(TileGrid, KeepsANoteWithEachTile) {
  Depths grid(64, 64);
  grid.TileAt(5, 40).note = 3;
  EXPECT_EQ(grid.TileAt(31, 63).note, 3) << "the same tile";
  EXPECT_EQ(grid.TileAt(5, 20).note, 0);
}

}  // namespace
}  // namespace limpet
