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

TEST(SemanticOctree, ABeamFreesItsWayAndHitsItsEnd) {
  SemanticOctree octree;
  octree.InsertBeam({0.1, 0.1, 3.5}, {0.1, 0.1, 7.5});
  EXPECT_GT(octree.At({0.1, 0.1, 7.5})->occupied, 0.0F);
  EXPECT_LT(octree.At({0.1, 0.1, 5.0})->occupied, 0.0F);
  EXPECT_FALSE(octree.At({0.1, 0.1, 8.0}));
}

TEST(SemanticOctree, BeamsDoNotTouchWhatIsKnownOfObjects) {
  SemanticOctree octree;
  octree.Set({0.1, 0.1, 7.5}, kObject);
  for (int i = 0; i < 50; ++i) {
    octree.InsertBeam({0.1, 0.1, 3.5}, {0.1, 0.1, 7.5});
  }
  EXPECT_EQ(octree.At({0.1, 0.1, 7.5})->object, kObject.object);
  EXPECT_EQ(octree.At({0.1, 0.1, 7.5})->label, kObject.label);
}

TEST(SemanticOctree, EqualVoxelsMergeButOnesThatDifferInOneBeliefDoNot) {
  SemanticOctree octree;
  for (int round = 0; round < 40; ++round) {  // enough to reach the clamp everywhere
    for (double north = 0.1; north < 0.8; north += 0.2) {
      for (double east = 0.1; east < 0.8; east += 0.2) {
        octree.InsertBeam({north, east, 0.1}, {north, east, 1.7});
      }
    }
  }
  const std::size_t merged = octree.nodes();
  octree.Set({0.1, 0.1, 0.3}, kObject);
  EXPECT_GT(octree.nodes(), merged);
  EXPECT_EQ(octree.At({0.1, 0.1, 0.3}), kObject);
  EXPECT_EQ(octree.At({0.3, 0.1, 0.3})->object, 0.0F) << "its seven siblings stay as they were";
}

TEST(SemanticOctree, ForgetsAVoxel) {
  SemanticOctree octree;
  octree.Set({1.1, 1.1, 1.1}, kObject);
  octree.Forget({1.1, 1.1, 1.1});
  EXPECT_EQ(octree.At({1.1, 1.1, 1.1}), VoxelBelief{});
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
    octree.InsertBeam({0, 0, 3.5}, p);
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
