// SPDX-License-Identifier: MIT
#include "estimation/mapping/map_export.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

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
  const std::string csv = ToCsv(OccupiedOf(OneVoxel()));
  EXPECT_EQ(std::ranges::count(csv, '\n'), 2);
  EXPECT_THAT(csv, HasSubstr("\n1.100,2.100,3.100,0.200,0.7006,0.7311,0.5000,new\n"));
}

TEST(MapExport, PlyIsEastNorthUp) {
  const std::string ply = ToPly(OccupiedOf(OneVoxel()));
  EXPECT_THAT(ply, HasSubstr("element vertex 1\n"));
  EXPECT_THAT(ply, HasSubstr("end_header\n2.100 1.100 -3.100 0 114 178\n"));
}

TEST(MapExport, ColorOctreeIsOneThatOctovisOpens) {
  const std::string bytes = ToColorOctree(OccupiedOf(OneVoxel()));
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
  const OccupiedMap empty{.resolution = 0.2, .voxels = {}};
  EXPECT_NE(ToColorOctree(empty).find("id ColorOcTree"), std::string::npos);
  EXPECT_NE(ToPly(empty).find("element vertex 0\n"), std::string::npos);
  EXPECT_EQ(ToCsv(empty).find('\n'), ToCsv(empty).size() - 1) << "the header alone";
}

TEST(MapExport, OfASavedMapIsWhatItWouldBeOfItsTree) {
  Random random(4, "voxels");
  SemanticOctree octree(Meters(0.25));
  for (int i = 0; i < 3000; ++i) {
    const Eigen::Vector3d p_W(random.Uniform(-9.0, 9.0), random.Uniform(-40.0, -31.0),
                              random.Uniform(6.0, 7.5));
    octree.Set(p_W, {.occupied = static_cast<float>(random.Uniform(-2.0, 3.4)),
                     .label = static_cast<VoxelLabel>(i % 6)});
  }
  for (int i = 0; i < 8; ++i) {  // these become one leaf
    octree.Set({0.1 + 0.25 * (i & 1), 0.1 + 0.25 * (i >> 1 & 1), 0.1 + 0.25 * (i >> 2)},
               {.occupied = 1.0F});
  }
  const Expected<OccupiedMap> saved = OccupiedOfStream(octree.Serialize());
  ASSERT_TRUE(saved);
  EXPECT_GT(saved->voxels.size(), 1000U);
  const OccupiedMap occupied = OccupiedOf(octree);
  EXPECT_EQ(ToCsv(*saved), ToCsv(occupied));
  EXPECT_EQ(ToPly(*saved), ToPly(occupied));
  EXPECT_EQ(ToColorOctree(*saved), ToColorOctree(occupied));
}

TEST(MapExport, OfASavedMapThatIsCutOrHasALabelOfNoMeaningIsRefused) {
  std::string bytes = OneVoxel().Serialize();
  EXPECT_FALSE(OccupiedOfStream(bytes.substr(0, bytes.size() - 1)));
  EXPECT_FALSE(OccupiedOfStream("no map"));
  bytes[bytes.size() - 2] = 6;
  EXPECT_FALSE(OccupiedOfStream(bytes));
  EXPECT_FALSE(SemanticOctree::Parse(bytes));
}

}  // namespace
}  // namespace limpet
