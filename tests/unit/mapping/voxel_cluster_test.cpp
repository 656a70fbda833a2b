// SPDX-License-Identifier: MIT
#include "estimation/mapping/voxel_cluster.hpp"

#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

constexpr double kEdge = 0.1;  // of a voxel [m]

/// Voxels of the upper half of a sphere's surface.
std::vector<VoxelKey> UpperShell(const Eigen::Vector3d& centre_W, double radius) {
  std::set<VoxelKey> keys;
  for (int i = 0; i < 60; ++i) {
    for (int j = 0; j < 20; ++j) {
      const double azimuth = 2.0 * M_PI * i / 60.0, polar = 0.5 * M_PI * j / 20.0;
      const Eigen::Vector3d outward(std::sin(polar) * std::cos(azimuth),
                                    std::sin(polar) * std::sin(azimuth), -std::cos(polar));
      keys.insert(KeyOf(centre_W + radius * outward, kEdge));
    }
  }
  return {keys.begin(), keys.end()};
}

TEST(VoxelKey, IsTheFloorAlsoBelowZero) {
  EXPECT_EQ(KeyOf({0.05, 0.15, 0.25}, 0.1), (VoxelKey{0, 1, 2}));
  EXPECT_EQ(KeyOf({-0.05, -0.15, -0.25}, 0.1), (VoxelKey{-1, -2, -3}));
}

TEST(VoxelKey, ItsCentreIsWithinAHalfOfEveryPointOfIt) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const double edge = random.Uniform(0.05, 0.5);
    const Eigen::Vector3d p_W(random.Normal(20.0), random.Normal(20.0), random.Normal(20.0));
    const VoxelKey key = KeyOf(p_W, edge);
    EXPECT_LE((CentreOf(key, edge) - p_W).cwiseAbs().maxCoeff(), 0.5 * edge + 1e-9);
    EXPECT_EQ(KeyOf(CentreOf(key, edge), edge), key);
  }
}

TEST(LargestCluster, IsNoneWithoutVoxels) {
  EXPECT_FALSE(LargestCluster({}, {.radius = 0.5, .spacing = kEdge}));
}

TEST(LargestCluster, OfOneVoxelIsThatVoxel) {
  const auto cluster = LargestCluster({{3, -4, 5}}, {.radius = 0.5, .spacing = kEdge});
  ASSERT_TRUE(cluster);
  EXPECT_EQ(cluster->voxels, 1);
  EXPECT_TRUE(cluster->centre_W.isApprox(CentreOf({3, -4, 5}, kEdge)));
  // Anywhere in it: a uniform spread over its edge.
  EXPECT_NEAR(cluster->deviation_W.x(), kEdge / std::sqrt(12.0), 1e-12);
}

TEST(LargestCluster, JoinsVoxelsThatTouchInACornerOnly) {
  EXPECT_EQ(
      LargestCluster({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {.radius = 0.5, .spacing = kEdge})->voxels,
      3);
  EXPECT_EQ(LargestCluster({{0, 0, 0}, {2, 2, 2}}, {.radius = 0.5, .spacing = kEdge})->voxels, 1);
}

TEST(LargestCluster, CountsAVoxelThatIsGivenTwiceOnce) {
  EXPECT_EQ(
      LargestCluster({{0, 0, 0}, {0, 0, 1}, {0, 0, 0}}, {.radius = 0.5, .spacing = kEdge})->voxels,
      2);
}

class LargestClusterProperties : public ::testing::TestWithParam<int> {
 protected:
  Random random_{static_cast<std::uint64_t>(GetParam()), "cluster"};
};

TEST_P(LargestClusterProperties, LiesAboutTheCentreOfTheSphereItIsOf) {
  const Eigen::Vector3d centre_W(random_.Normal(10.0), random_.Normal(10.0), random_.Normal(5.0));
  const double radius = random_.Uniform(0.4, 0.8);
  const auto cluster =
      LargestCluster(UpperShell(centre_W, radius), {.radius = radius, .spacing = kEdge});
  ASSERT_TRUE(cluster);
  EXPECT_LT((cluster->centre_W - centre_W).norm(), 0.05);
  EXPECT_LT(cluster->deviation_W.z(), cluster->deviation_W.x())
      << "half a sphere is flatter than wide";
}

TEST_P(LargestClusterProperties, IsNotMovedByASmallerOneOrByTheOrderOfVoxels) {
  const Eigen::Vector3d centre_W(random_.Normal(10.0), random_.Normal(10.0), random_.Normal(5.0));
  std::vector<VoxelKey> voxels = UpperShell(centre_W, 0.5);
  const auto alone = LargestCluster(voxels, {.radius = 0.5, .spacing = kEdge});
  const auto count = static_cast<std::size_t>(alone->voxels);
  for (const VoxelKey& key : UpperShell(centre_W + Eigen::Vector3d(5.0, 0.0, 0.0), 0.2))
    voxels.push_back(key);
  for (std::size_t i = voxels.size(); i > 1; --i)
    std::swap(voxels[i - 1], voxels[random_.Index(i)]);
  const auto among = LargestCluster(voxels, {.radius = 0.5, .spacing = kEdge});
  ASSERT_TRUE(among);
  EXPECT_EQ(static_cast<std::size_t>(among->voxels), count);
  EXPECT_LT((among->centre_W - alone->centre_W).norm(), 1e-9);
}

TEST_P(LargestClusterProperties, MovesWithItsVoxels) {
  const Eigen::Vector3d centre_W(random_.Normal(3.0), random_.Normal(3.0), random_.Normal(3.0));
  const std::vector<VoxelKey> voxels = UpperShell(centre_W, 0.5);
  std::vector<VoxelKey> moved = voxels;
  for (VoxelKey& key : moved)
    key[0] += 7, key[1] -= 3, key[2] += 11;
  const auto here = LargestCluster(voxels, {.radius = 0.5, .spacing = kEdge}),
             there = LargestCluster(moved, {.radius = 0.5, .spacing = kEdge});
  const Eigen::Vector3d shift = kEdge * Eigen::Vector3d(7.0, -3.0, 11.0);
  EXPECT_LT((there->centre_W - here->centre_W - shift).norm(), 1e-6);
  EXPECT_LT((there->deviation_W - here->deviation_W).norm(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Drawn, LargestClusterProperties, ::testing::Range(1, 9));

}  // namespace
}  // namespace limpet
