// SPDX-License-Identifier: MIT
#include "estimation/scene/map_scene.hpp"

#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/opengl/CEllipsoid3D.h>
#include <mrpt/opengl/COctoMapVoxels.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/opengl/CText.h>
#include <mrpt/serialization/CArchive.h>

#include "estimation/mapping/map_export.hpp"

namespace limpet {
namespace {

/// What a viewer makes of the bytes.
mrpt::opengl::COpenGLScene Read(const std::string& bytes) {
  mrpt::io::CMemoryStream memory;
  memory.assignMemoryNotOwn(bytes.data(), bytes.size());
  mrpt::opengl::COpenGLScene scene;
  mrpt::serialization::archiveFrom(memory) >> scene;
  return scene;
}

template <class T>
std::shared_ptr<T> Named(mrpt::opengl::COpenGLScene scene, const std::string& name) {
  return std::dynamic_pointer_cast<T>(scene.getByName(name));
}

SemanticOctree TwoVoxels() {
  SemanticOctree octree;
  octree.Set({1.1, 2.1, 3.1}, {.occupied = 0.85F, .object = 1.0F, .label = VoxelLabel::kNew});
  octree.Set({1.1, 2.3, 3.5}, {.occupied = 0.85F});
  octree.Set({5.1, 2.1, 3.1}, {.occupied = -0.4F});
  return octree;
}

OpiBelief Object(int id, Status decided) {
  OpiBelief opi;
  opi.id = id;
  opi.decided = decided;
  opi.object.p_W = {10.0, 20.0, 5.0};
  opi.object.cov_W = Eigen::Vector3d(0.09, 0.04, 0.01).asDiagonal();
  opi.object.cov_W(0, 2) = opi.object.cov_W(2, 0) = 0.02;
  opi.object.color = "yellow";
  return opi;
}

TEST(MapScene, HoldsOccupiedVoxelsByLabelEastNorthUp) {
  const auto seabed =
      Named<mrpt::opengl::COctoMapVoxels>(Read(ToScene(TwoVoxels(), {}, {})), "seabed");
  ASSERT_TRUE(seabed);
  const auto is_new = static_cast<std::size_t>(VoxelLabel::kNew);
  EXPECT_EQ(seabed->getVoxelCount(static_cast<std::size_t>(VoxelLabel::kGround)), 1U);
  ASSERT_EQ(seabed->getVoxelCount(is_new), 1U);
  const auto& voxel = seabed->getVoxel(is_new, 0);
  EXPECT_NEAR(voxel.coords.x, 2.1, 1e-5);
  EXPECT_NEAR(voxel.coords.y, 1.1, 1e-5);
  EXPECT_NEAR(voxel.coords.z, -3.1, 1e-5);
  EXPECT_NEAR(voxel.side_length, 0.2, 1e-9);
  EXPECT_EQ(voxel.color.G, ColorOf({.label = VoxelLabel::kNew}).green);
}

TEST(MapScene, HoldsEachObjectWithItsCovariance) {
  auto scene = Read(ToScene(TwoVoxels(), {Object(3, Status::kNew)}, {}));
  const auto ellipsoid = Named<mrpt::opengl::CEllipsoid3D>(scene, "object 3");
  ASSERT_TRUE(ellipsoid);
  EXPECT_NEAR(ellipsoid->getPoseX(), 20.0, 1e-9);
  EXPECT_NEAR(ellipsoid->getPoseY(), 10.0, 1e-9);
  EXPECT_NEAR(ellipsoid->getPoseZ(), -5.0, 1e-9);
  EXPECT_NEAR(ellipsoid->getQuantiles(), 3.0, 1e-9);
  const auto& cov = ellipsoid->getCovMatrix();
  EXPECT_NEAR(cov(0, 0), 0.04, 2e-6) << "east";
  EXPECT_NEAR(cov(1, 1), 0.09, 2e-6) << "north";
  EXPECT_NEAR(cov(1, 2), -0.02, 2e-6) << "what errs north errs down, not up";
  EXPECT_EQ(ellipsoid->getColor_u8().G, ColorOf({.label = VoxelLabel::kNew}).green);
  const auto objects = Named<mrpt::opengl::CSetOfObjects>(scene, "objects");
  ASSERT_TRUE(objects);
  EXPECT_EQ(objects->getByClass<mrpt::opengl::CText>()->getString(), "3 yellow new");
}

TEST(MapScene, ShowsNothingOfWhatIsDecidedToBeNothing) {
  auto scene = Read(ToScene(TwoVoxels(), {Object(3, Status::kNothing)}, {}));
  EXPECT_FALSE(Named<mrpt::opengl::CEllipsoid3D>(scene, "object 3"));
}

TEST(MapScene, HoldsThePathIfThereIsOne) {
  auto scene = Read(ToScene(TwoVoxels(), {}, {{1, 2, 3}, {2, 2, 3}, {2, 5, 4}}));
  const auto path = Named<mrpt::opengl::CSetOfLines>(scene, "path");
  ASSERT_TRUE(path);
  ASSERT_EQ(path->getLineCount(), 2U);
  EXPECT_EQ(path->rbegin()->point2, mrpt::math::TPoint3D(5.0, 2.0, -4.0));
  EXPECT_FALSE(Read(ToScene(TwoVoxels(), {}, {{1, 2, 3}})).getByName("path"));
}

TEST(MapScene, OfAnEmptyMapIsOne) {
  EXPECT_TRUE(Read(ToScene(SemanticOctree(), {}, {})).getByName("seabed"));
}

}  // namespace
}  // namespace limpet
