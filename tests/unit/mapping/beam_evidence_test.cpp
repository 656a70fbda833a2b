// SPDX-License-Identifier: MIT
#include "estimation/mapping/beam_evidence.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

constexpr double kVoxelEdge = 0.2;

struct TestBeam {
  Eigen::Vector3d origin_W, end_W;
};

std::vector<TestBeam> RandomBeams(int count) {
  Random random(11);
  std::vector<TestBeam> beams;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d origin(random.Uniform(-9, 9), random.Uniform(-9, 9),
                                 random.Uniform(-1, 4));
    const Eigen::Vector3d way(random.Uniform(-4, 4), random.Uniform(-4, 4), random.Uniform(-6, 6));
    beams.push_back({.origin_W = origin, .end_W = origin + way});
  }
  return beams;
}

std::map<VoxelKey, VoxelCounts> KnownOf(const BeamEvidence& evidence) {
  std::map<VoxelKey, VoxelCounts> known;
  for (const TileKey& tile : evidence.Tiles()) {
    evidence.ForEachKnown(
        tile, [&](const VoxelKey& key, const VoxelCounts& counts) { known[key] = counts; });
  }
  return known;
}

TEST(BeamEvidence, ABeamFreesItsWayAndHitsItsEnd) {
  BeamEvidence evidence(kVoxelEdge);
  evidence.Add({0.1, 0.1, 3.5}, {0.1, 0.1, 7.5});
  EXPECT_EQ(evidence.At(KeyOf({0.1, 0.1, 7.5}, kVoxelEdge)), (VoxelCounts{.hits = 1}));
  EXPECT_EQ(evidence.At(KeyOf({0.1, 0.1, 5.0}, kVoxelEdge)), (VoxelCounts{.misses = 1}));
  EXPECT_EQ(evidence.At(KeyOf({0.1, 0.1, 3.5}, kVoxelEdge)), (VoxelCounts{.misses = 1}));
  EXPECT_FALSE(evidence.At(KeyOf({0.1, 0.1, 8.0}, kVoxelEdge)).is_known());
}

TEST(BeamEvidence, ABeamWithinOneVoxelOnlyHitsIt) {
  BeamEvidence evidence(kVoxelEdge);
  evidence.Add({0.05, 0.1, 0.1}, {0.15, 0.1, 0.1});
  EXPECT_EQ(KnownOf(evidence), (std::map<VoxelKey, VoxelCounts>{{{0, 0, 0}, {.hits = 1}}}));
}

TEST(BeamEvidence, WalksThroughAllVoxelsBetweenBothEndsAndNoOthers) {
  for (const TestBeam& beam : RandomBeams(300)) {
    BeamEvidence evidence(kVoxelEdge);
    evidence.Add(beam.origin_W, beam.end_W);
    const std::map<VoxelKey, VoxelCounts> known = KnownOf(evidence);
    const Eigen::Vector3d way = beam.end_W - beam.origin_W;
    for (double share = 0.0; share <= 1.0; share += 1e-3) {
      EXPECT_TRUE(known.contains(KeyOf(beam.origin_W + share * way, kVoxelEdge)));
    }
    for (const auto& [key, counts] : known) {  // its centre is within half a voxel's diagonal
      const Eigen::Vector3d off = CentreOf(key, kVoxelEdge) - beam.origin_W;
      EXPECT_LT(off.cross(way.normalized()).norm(), 0.5 * std::sqrt(3.0) * kVoxelEdge + 1e-9);
    }
  }
}

TEST(BeamEvidence, WhatIsTakenBackInAnyOrderLeavesNothing) {
  BeamEvidence evidence(kVoxelEdge);
  const std::vector<TestBeam> beams = RandomBeams(500);
  for (const TestBeam& beam : beams) {
    evidence.Add(beam.origin_W, beam.end_W);
  }
  EXPECT_FALSE(KnownOf(evidence).empty());
  for (auto beam = beams.rbegin(); beam != beams.rend(); ++beam) {
    evidence.TakeBack(beam->origin_W, beam->end_W);
  }
  EXPECT_TRUE(KnownOf(evidence).empty());
}

/// A vehicle that waits at the surface for half a day.
TEST(BeamEvidence, CountsAndTakesBackMoreBeamsInAPlaceThanTwoBytesHold) {
  constexpr std::uint32_t kBeams = 150'000;
  BeamEvidence evidence(kVoxelEdge);
  const Eigen::Vector3d origin(0.1, 0.1, 0.1), end(0.1, 0.1, 0.3);
  const auto misses = [&] { return evidence.At(KeyOf(origin, kVoxelEdge)).misses; };
  const auto hits = [&] { return evidence.At(KeyOf(end, kVoxelEdge)).hits; };
  for (std::uint32_t i = 0; i < kBeams; ++i)
    evidence.Add(origin, end);
  EXPECT_EQ(misses(), kBeams);
  EXPECT_EQ(hits(), kBeams);
  EXPECT_EQ(KnownOf(evidence)[KeyOf(end, kVoxelEdge)], (VoxelCounts{.hits = kBeams}));
  for (std::uint32_t i = 1; i < kBeams; ++i)
    evidence.TakeBack(origin, end);
  EXPECT_EQ(misses(), 1U);
  EXPECT_EQ(hits(), 1U);
  evidence.TakeBack(origin, end);
  EXPECT_TRUE(KnownOf(evidence).empty());
}

TEST(BeamEvidence, TellsOnceWhichTilesHaveChangedAlsoWhereNothingIsLeft) {
  BeamEvidence evidence(kVoxelEdge);
  const std::vector<TileKey> its_tile{{0, 0}};
  evidence.Add({0.1, 0.1, 3.5}, {0.1, 0.1, 7.5});
  EXPECT_EQ(evidence.TakeChanged(), its_tile);
  EXPECT_TRUE(evidence.TakeChanged().empty());
  evidence.TakeBack({0.1, 0.1, 3.5}, {0.1, 0.1, 7.5});
  EXPECT_EQ(evidence.TakeChanged(), its_tile);
  EXPECT_TRUE(KnownOf(evidence).empty());
}

TEST(BeamEvidence, DropsWhatHasNotBeenUsedForLongestAndTakesItUpAgain) {
  constexpr std::size_t kRoomForOneBeam = 12'000;
  BeamEvidence evidence(kVoxelEdge, kRoomForOneBeam);
  const TileKey first{0, 0}, second{1, 0};
  const Eigen::Vector3d at_first(0.1, 0.1, 3.5), down(0.0, 0.0, 4.0), at_second(14.0, 0.1, 3.5);
  evidence.Add(at_first, at_first + down);
  evidence.Add(at_second, at_second + down);
  evidence.DropUnused();
  EXPECT_TRUE(evidence.IsDropped(first));
  EXPECT_FALSE(evidence.IsDropped(second));
  EXPECT_LE(evidence.bytes(), kRoomForOneBeam);
  evidence.Add(at_first, at_first + down);  // passes it by
  EXPECT_TRUE(evidence.IsDropped(first));
  evidence.Hold(first, [&](const BeamEvidence::BeamVisitor& visit) {
    visit(at_first, at_first + down);
    visit(at_first, at_first + down);
    visit(at_second, at_second + down);
  });
  EXPECT_EQ(evidence.At(KeyOf(at_first + down, kVoxelEdge)), (VoxelCounts{.hits = 2}));
  EXPECT_TRUE(evidence.IsDropped(second));
}

TEST(BeamEvidence, HoldsWhatAnOctreeCanAndNoNumbersThatAreNone) {
  const BeamEvidence evidence(kVoxelEdge);
  EXPECT_TRUE(evidence.Holds({6500.0, -6500.0, 0.0}));
  EXPECT_FALSE(evidence.Holds({6600.0, 0.0, 0.0}));
  EXPECT_FALSE(evidence.Holds({0.0, std::numeric_limits<double>::quiet_NaN(), 0.0}));
}

TEST(OccupiedLogOdds, IsOctoMapsModelWithinItsBounds) {
  EXPECT_EQ(OccupiedLogOdds({}), 0.0F);
  EXPECT_NEAR(OccupiedLogOdds({.hits = 1}), std::log(0.7 / 0.3), 1e-6);
  EXPECT_NEAR(OccupiedLogOdds({.misses = 1}), std::log(0.4 / 0.6), 1e-6);
  EXPECT_NEAR(OccupiedLogOdds({.hits = 2, .misses = 1}), 1.28913, 1e-4);
  EXPECT_EQ(OccupiedLogOdds({.hits = 1000}), 3.5F);
  EXPECT_EQ(OccupiedLogOdds({.misses = 1000}), -2.0F);
}

}  // namespace
}  // namespace limpet
