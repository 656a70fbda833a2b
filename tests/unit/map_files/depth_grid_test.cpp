// SPDX-License-Identifier: MIT
#include "limpet/map_files/depth_grid.hpp"

#include <gtest/gtest.h>

#include "limpet/map_files/ascii_grid.hpp"

namespace limpet {
namespace {

SemanticOctree Slope() {
  SemanticOctree octree;
  for (int i = 0; i < 10; ++i) {
    octree.Set({0.1 + 0.2 * i, 0.1, 7.1 + 0.2 * i}, {.occupied = 2.0F});
    octree.Set({0.1 + 0.2 * i, 0.3, 7.1 + 0.2 * i}, {.occupied = 2.0F});
  }
  return octree;
}

TEST(DepthGrid, HasTheDepthOfEachColumnOfTheSeabed) {
  const DepthGrid grid = DepthGridOf(Slope());
  EXPECT_EQ(grid.frame.rows, 10);
  EXPECT_EQ(grid.frame.columns, 2);
  const auto cell = grid.At({1.1, 0.1});
  ASSERT_TRUE(cell);
  EXPECT_NEAR(static_cast<double>(grid.down_m[*cell]), 8.1, 1e-3);
  EXPECT_NEAR(static_cast<double>(grid.sigma_m[*cell]), 0.2 / std::sqrt(12.0), 1e-3);
}

TEST(DepthGrid, KnowsNothingBesideIt) {
  const DepthGrid grid = DepthGridOf(Slope());
  EXPECT_FALSE(grid.At({-5.0, 0.1}));
  EXPECT_FALSE(grid.At({1.0, std::nan("")}));
  EXPECT_FALSE(DepthGridOf(SemanticOctree()).At({0.0, 0.0}));
}

TEST(DepthGrid, AnObjectIsNotTheSeabed) {
  SemanticOctree octree = Slope();
  octree.Set({1.1, 0.1, 5.1}, {.occupied = 3.0F, .label = VoxelLabel::kConfirmed});
  const DepthGrid grid = DepthGridOf(octree);
  EXPECT_NEAR(static_cast<double>(grid.down_m[*grid.At({1.1, 0.1})]), 8.1, 1e-3);
}

TEST(DepthGrid, FollowsWhereMostBeamsEnded) {
  SemanticOctree octree = Slope();
  octree.Set({1.1, 0.1, 6.1}, {.occupied = 0.5F});  // a fish
  const DepthGrid grid = DepthGridOf(octree);
  EXPECT_NEAR(static_cast<double>(grid.down_m[*grid.At({1.1, 0.1})]), 8.1, 1e-3);
}

SessionMemory MemoryWith(const std::string& depths, const std::string& map) {
  SessionMemory memory;
  memory.depths = depths;
  if (!map.empty()) memory.map["map.ot"] = map;
  return memory;
}

TEST(DepthGrid, IsAsFineAsTheSessionKeptIt) {
  DepthMap depths(0.2);
  for (int i = 0; i < 10; ++i) {
    depths.Add({1.1, 0.1, i % 2 == 0 ? 8.03 : 8.05});
  }
  depths.Add({2.1, -0.9, 8.3});
  depths.SetZeroSigma(0.07);
  const auto grid = DepthGridOf(MemoryWith(depths.Serialize(), Slope().Serialize()));
  ASSERT_TRUE(grid) << grid.error().text;
  EXPECT_EQ(grid->frame.rows, 6);
  EXPECT_EQ(grid->frame.columns, 6);
  EXPECT_EQ(grid->zero_sigma_m, 0.07);
  const auto cell = grid->At({1.1, 0.1});
  ASSERT_TRUE(cell);
  EXPECT_NEAR(static_cast<double>(grid->down_m[*cell]), 8.04, 1e-3);
  EXPECT_LT(static_cast<double>(grid->sigma_m[*cell]), 0.012);
  EXPECT_FALSE(grid->At({1.5, 0.1}));
}

TEST(DepthGrid, OfAnOlderSessionIsThatOfItsVoxels) {
  const auto grid = DepthGridOf(MemoryWith("", Slope().Serialize()));
  ASSERT_TRUE(grid) << grid.error().text;
  EXPECT_EQ(grid->frame.rows, 10);
  EXPECT_EQ(DepthGridOf(MemoryWith("", ""))->frame.rows, 0);
}

TEST(DepthGrid, NamesTheFileThatIsDamaged) {
  const std::string vast =
      "cell_m=0.2,zero_sigma_m=0\nnorth,east,beams,down_mm,square_mm2\n"
      "-2000000000,-2000000000,1,7000,49000000\n2000000000,2000000000,1,7000,49000000\n";
  EXPECT_EQ(DepthGridOf(MemoryWith(vast, "")).error().text,
            "depths.csv: its columns lie too far apart");
  EXPECT_EQ(DepthGridOf(MemoryWith("no depths", "")).error().text,
            "depths.csv: says no cell_m and zero_sigma_m");
  EXPECT_TRUE(DepthGridOf(MemoryWith("", "no octree")).error().text.starts_with("map.ot: "));
}

TEST(AsciiGrid, HasItsRowsFromTheNorth) {
  SemanticOctree octree;
  octree.Set({0.1, 0.1, 7.1}, {.occupied = 2.0F});
  octree.Set({0.3, 0.3, 8.1}, {.occupied = 2.0F});
  const DepthGrid grid = DepthGridOf(octree);
  EXPECT_EQ(ToAsciiGrid(grid, grid.down_m),
            "ncols 2\nnrows 2\nxllcorner 0.000\nyllcorner 0.000\ncellsize 0.2\n"
            "NODATA_value -9999\n-9999 8.100\n7.100 -9999\n");
}

}  // namespace
}  // namespace limpet
