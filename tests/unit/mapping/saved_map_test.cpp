// SPDX-License-Identifier: MIT
#include "estimation/mapping/saved_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

/// Voxels of all kinds over several tiles, a cube of equal ones among them.
SemanticOctree SomeMap() {
  SemanticOctree octree;
  Random random(4);
  for (int i = 0; i < 3000; ++i) {
    octree.Set(
        {random.Uniform(-30.0, 30.0), random.Uniform(-30.0, 30.0), random.Uniform(-1.0, 9.0)},
        {.occupied = static_cast<float>(random.Uniform(-1.5, 3.0))});
  }
  for (int i = 0; i < 512; ++i) {
    octree.Set({0.1 + 0.2 * (i % 8), 0.1 + 0.2 * (i / 8 % 8), 0.1 + 0.2 * (i / 64)},
               {.occupied = -1.0F});
  }
  return octree;
}

MapFiles FilesOfTiles(const std::string& octree) {
  MapFiles files;
  const Expected<std::vector<MapTile>> tiles = TilesOf(octree);
  for (const MapTile& tile : *tiles) {
    files[std::to_string(tile.key.north) + "_" + std::to_string(tile.key.east)] = tile.packed;
  }
  return files;
}

TEST(SavedMap, IsTheSameInTilesAsInAWhole) {
  const std::string whole = SomeMap().Serialize();
  const MapFiles tiles = FilesOfTiles(whole);
  EXPECT_GE(tiles.size(), 25U);
  const Expected<SemanticOctree> read = OctreeOf(tiles);
  ASSERT_TRUE(read) << read.error().text;
  EXPECT_EQ(read->Serialize(), whole);
  const Expected<SemanticOctree> of_old = OctreeOf(MapFiles{{"map.ot", whole}});
  ASSERT_TRUE(of_old) << of_old.error().text;
  EXPECT_EQ(of_old->Serialize(), whole);
  EXPECT_EQ(OccupiedOf(tiles)->voxels.size(), OccupiedOf(*read).voxels.size());
}

TEST(SavedMap, NamesTheFileThatIsDamaged) {
  MapFiles files = FilesOfTiles(SomeMap().Serialize());
  files.begin()->second.resize(40);
  EXPECT_THAT(OctreeOf(files).error().text, testing::StartsWith(files.begin()->first + ": "));
  EXPECT_THAT(OccupiedOf(files).error().text, testing::StartsWith(files.begin()->first + ": "));
  SemanticOctree coarse(Meters(0.5));
  coarse.Set({1.0, 1.0, 1.0}, {.occupied = 1.0F});
  files = FilesOfTiles(SomeMap().Serialize());
  files["other"] = coarse.Serialize();
  EXPECT_EQ(OctreeOf(files).error().text,
            "other: voxels of 0.5 m, in the other tiles they are of 0.2 m");
  EXPECT_FALSE(TilesOf("no octree"));
}

}  // namespace
}  // namespace limpet
