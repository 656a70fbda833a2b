// SPDX-License-Identifier: MIT
#include "estimation/mapping/map_export.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limpet {
namespace {

using ::testing::HasSubstr;

SemanticOctree OneVoxel() {
  SemanticOctree octree;
  octree.Set({1.1, 2.1, 3.1}, {.occupied = 0.85F, .object = 1.0F, .label = VoxelLabel::kNew});
  octree.Set({5.1, 2.1, 3.1}, {.occupied = -0.4F});
  return octree;
}

TEST(MapExport, CsvListsOccupiedVoxelsInNed) {
  const std::string csv = ToCsv(OneVoxel());
  EXPECT_EQ(std::ranges::count(csv, '\n'), 2);
  EXPECT_THAT(csv, HasSubstr("\n1.100,2.100,3.100,0.200,0.7006,0.7311,0.5000,new\n"));
}

TEST(MapExport, PlyIsEastNorthUp) {
  const std::string ply = ToPly(OneVoxel());
  EXPECT_THAT(ply, HasSubstr("element vertex 1\n"));
  EXPECT_THAT(ply, HasSubstr("end_header\n2.100 1.100 -3.100 0 158 115\n"));
}

TEST(MapExport, ColorOctreeIsOneThatOctovisOpens) {
  const std::string bytes = ToColorOctree(OneVoxel());
  EXPECT_THAT(bytes, ::testing::StartsWith("# Octomap OcTree file"));
  EXPECT_THAT(bytes, HasSubstr("id ColorOcTree\n"));
}

TEST(MapExport, EveryStatusHasItsOwnColour) {
  std::vector<std::array<int, 3>> colors;
  for (int label = 0; label < 6; ++label) {
    const VoxelColor c = ColorOf({.label = static_cast<VoxelLabel>(label)});
    colors.push_back({c.red, c.green, c.blue});
  }
  std::ranges::sort(colors);
  EXPECT_EQ(std::ranges::adjacent_find(colors), colors.end());
}

TEST(MapExport, OfAnEmptyMapHoldsNothing) {
  const SemanticOctree empty;
  EXPECT_NE(ToColorOctree(empty).find("id ColorOcTree"), std::string::npos);
  EXPECT_NE(ToPly(empty).find("element vertex 0\n"), std::string::npos);
  EXPECT_EQ(ToCsv(empty).find('\n'), ToCsv(empty).size() - 1) << "the header alone";
}

}  // namespace
}  // namespace limpet
