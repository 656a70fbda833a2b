// SPDX-License-Identifier: MIT
#include "limpet/session/map_tile_table.hpp"

#include <gtest/gtest.h>

namespace limpet {
namespace {

TEST(TileFile, IsReadAsTheTileItIsOf) {
  const TileKey key{-12, 7};
  EXPECT_EQ(TileFile(key), "map/-12_7.ot.gz");
  EXPECT_EQ(TileOfFile(TileFile(key)), key);
  for (const char* other : {"map.ot", "map/1_2.ot", "map/1.ot.gz", "map/a_2.ot.gz", "1_2.ot.gz",
                            "map/1_99999999999.ot.gz", "map/_.ot.gz"}) {
    EXPECT_FALSE(TileOfFile(other)) << other;
  }
}

TEST(MapTileTable, IsOfWhatTheMapIsNow) {
  MapTileTable sender, reader;
  const MapTile first{{0, 0}, "a"}, second{{0, 1}, "b"}, changed{{0, 1}, "c"};
  for (const MapTile& tile : {first, second, changed})
    sender.Put(tile);
  for (const MapTile& tile : {second, first})
    reader.Put(tile);
  EXPECT_EQ(sender.List().tiles, 2);
  EXPECT_EQ(reader.List().tiles, 2);
  EXPECT_NE(sender.List(), reader.List());
  reader.Put(changed);
  EXPECT_EQ(sender.List(), reader.List());
  sender.Put({.key = first.key, .packed = {}});
  EXPECT_EQ(sender.List().tiles, 1);
  EXPECT_FALSE(sender.Has(first.key));
}

}  // namespace
}  // namespace limpet
