// SPDX-License-Identifier: MIT
#include "estimation/mapping/semantic_octree.hpp"

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

const VoxelBelief kObject{
    .occupied = 1.7F, .object = 2.2F, .exists = -1.5F, .label = VoxelLabel::kRemoved};

TEST(SemanticOctree, KnowsNothingAtFirst) {
  const SemanticOctree octree;
  EXPECT_FALSE(octree.At({1, 2, 3}));
  EXPECT_EQ(octree.nodes(), 0U);
}

TEST(SemanticOctree, KeepsAllBeliefsOfAVoxel) {
  SemanticOctree octree;
  octree.Set({1.1, -2.1, 6.3}, kObject);
  EXPECT_EQ(octree.At({1.1, -2.1, 6.3}), kObject);
  EXPECT_FALSE(octree.At({1.3, -2.1, 6.3})) << "the next voxel is another one";
}

TEST(SemanticOctree, EqualVoxelsAreSavedAsOneButOnesThatDifferInOneBeliefAreNot) {
  const VoxelBelief free{.occupied = -2.0F};
  SemanticOctree octree;
  for (int i = 0; i < 8; ++i) {
    octree.Set({0.1 + 0.2 * (i & 1), 0.1 + 0.2 * (i >> 1 & 1), 0.1 + 0.2 * (i >> 2)}, free);
  }
  static_cast<void>(octree.Serialize());
  const std::size_t merged = octree.nodes();
  octree.Set({0.1, 0.1, 0.3}, kObject);
  static_cast<void>(octree.Serialize());
  EXPECT_EQ(octree.nodes(), merged + 8);
  EXPECT_EQ(octree.At({0.1, 0.1, 0.3}), kObject);
  EXPECT_EQ(octree.At({0.3, 0.1, 0.3}), free) << "its seven siblings stay as they were";
}

TEST(SemanticOctree, WritesTheSameBytesHoweverTheMapCameToBe) {
  SemanticOctree once, twice;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d p(0.1 + 0.2 * (i & 1), 0.1 + 0.2 * (i >> 1 & 1), 0.1 + 0.2 * (i >> 2));
    twice.Set(p, kObject);
  }
  static_cast<void>(twice.Serialize());
  for (int i = 7; i >= 0; --i) {
    const Eigen::Vector3d p(0.1 + 0.2 * (i & 1), 0.1 + 0.2 * (i >> 1 & 1), 0.1 + 0.2 * (i >> 2));
    once.Set(p, {.occupied = -2.0F});
    twice.Set(p, {.occupied = -2.0F});
  }
  EXPECT_EQ(once.Serialize(), twice.Serialize());
}

SemanticOctree RandomOctree() {
  Random random(4);
  SemanticOctree octree(Meters(0.1));
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d p(random.Uniform(-5, 5), random.Uniform(-5, 5), random.Uniform(5, 8));
    octree.Set(p, {.occupied = static_cast<float>(random.Uniform(-1.9, 3.4)),
                   .object = static_cast<float>(random.Uniform(-3, 3)),
                   .exists = static_cast<float>(random.Uniform(-3, 3)),
                   .label = static_cast<VoxelLabel>(random.Index(6))});
  }
  return octree;
}

TEST(SemanticOctree, ComesBackFromItsBytesValueByValue) {
  const SemanticOctree saved = RandomOctree();
  const Expected<SemanticOctree> loaded = SemanticOctree::Parse(saved.Serialize());
  ASSERT_TRUE(loaded) << loaded.error().text;
  EXPECT_EQ(loaded->resolution(), 0.1);
  const std::vector<Voxel> before = saved.Leaves();
  const std::vector<Voxel> after = loaded->Leaves();
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(before[i].p_W, after[i].p_W);
    EXPECT_EQ(before[i].size, after[i].size);
    EXPECT_EQ(before[i].belief, after[i].belief);
  }
}

TEST(SemanticOctree, AnEmptyMapComesBackEmpty) {
  const Expected<SemanticOctree> loaded = SemanticOctree::Parse(SemanticOctree().Serialize());
  ASSERT_TRUE(loaded) << loaded.error().text;
  EXPECT_EQ(loaded->nodes(), 0U);
}

TEST(SemanticOctree, WritesEqualBytesForEqualMaps) {
  EXPECT_EQ(RandomOctree().Serialize(), RandomOctree().Serialize());
}

TEST(SemanticOctree, RefusesEveryTruncation) {
  SemanticOctree octree;
  octree.Set({0.1, 0.1, 0.1}, kObject);
  octree.Set({1.1, 0.1, 0.1}, kObject);
  const std::string bytes = octree.Serialize();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(SemanticOctree::Parse(bytes.substr(0, size))) << size;
  }
  EXPECT_FALSE(SemanticOctree::Parse(bytes + "x"));
}

TEST(SemanticOctree, SurvivesAnyFlippedBit) {
  SemanticOctree octree;
  octree.Set({0.1, 0.1, 0.1}, kObject);
  octree.Set({1.1, 0.1, 0.1}, kObject);
  const std::string good = octree.Serialize();
  for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
    std::string bad = good;
    bad[bit / 8] = static_cast<char>(bad[bit / 8] ^ (1 << (bit % 8)));
    // Payload bits are the checksum's business; structure must never lead the reader astray.
    const Expected<SemanticOctree> loaded = SemanticOctree::Parse(bad);
    if (loaded) {
      EXPECT_EQ(loaded->nodes(), octree.nodes());
    }
  }
}

}  // namespace
}  // namespace limpet
