// SPDX-License-Identifier: MIT
#include "estimation/mapping/semantic_map.hpp"

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

const VoxelBelief kPaintedBelief{
    .occupied = 1.7F, .object = 2.2F, .exists = -1.5F, .label = VoxelLabel::kRemoved};
const PosedBeams kLevelPing{
    .north = 0.0, .down = 3.5, .b1 = 4.4, .b2 = 4.4, .b3 = 4.4, .b4 = 4.4, .sd_down = {}};

void LayPing(SemanticMap& map, double t, double north) {
  PosedBeams ping = kLevelPing;
  ping.north = north;
  map.beams().Add(t, ping, BeamEnds(ping.pose(), {ping.b1, ping.b2, ping.b3, ping.b4}));
}

VoxelKey EndOfFirstBeam() {
  return KeyOf(BeamEnds(kLevelPing.pose(), {4.4, {}, {}, {}})[0].p_W, 0.2);
}

TEST(SemanticMap, KnowsNothingAtFirst) {
  SemanticMap map;
  EXPECT_FALSE(map.At({1, 2, 3}));
  EXPECT_EQ(map.Octree().nodes(), 0U);
}

TEST(SemanticMap, BeamsDoNotTouchWhatIsKnownOfObjects) {
  SemanticMap map;
  map.Paint(EndOfFirstBeam(), kPaintedBelief);
  for (int i = 0; i < 50; ++i) {
    LayPing(map, i, 0.0);
  }
  EXPECT_EQ(map.At(EndOfFirstBeam()), kPaintedBelief);
  EXPECT_EQ(map.Octree().At(CentreOf(EndOfFirstBeam(), 0.2)), kPaintedBelief);
}

TEST(SemanticMap, WhereAnObjectWasIsWhatBeamsSayAgain) {
  SemanticMap map;
  LayPing(map, 0.0, 0.0);
  const std::optional<VoxelBelief> ground = map.At(EndOfFirstBeam());
  ASSERT_TRUE(ground);
  EXPECT_GT(ground->occupied, 0.0F);
  map.Paint(EndOfFirstBeam(), kPaintedBelief);
  EXPECT_EQ(map.Octree().At(CentreOf(EndOfFirstBeam(), 0.2)), kPaintedBelief);
  map.Unpaint(EndOfFirstBeam());
  EXPECT_EQ(map.Octree().At(CentreOf(EndOfFirstBeam(), 0.2)), ground);
}

TEST(SemanticMap, ForgetsAnObjectWhereNoBeamHasBeen) {
  SemanticMap map;
  map.Paint({3, 3, 3}, kPaintedBelief);
  EXPECT_EQ(map.Octree().nodes(), 17U);
  map.Unpaint({3, 3, 3});
  EXPECT_EQ(map.Octree().nodes(), 0U);
}

TEST(SemanticMap, TheOctreeDoesNotDependOnWhenItWasReadNorOnHowTheTrackMoved) {
  const TrackShift shift{{{100.0, 0.75, -0.5, 0.0, 0.0}}};
  SemanticMap watched, unwatched;
  for (int i = 0; i < 100; ++i) {
    LayPing(watched, i, 0.125 * i);
    watched.Paint({i, 2, 30}, kPaintedBelief);
    if (i % 10 == 0) static_cast<void>(watched.Octree().Serialize());
    watched.Unpaint({i - 1, 2, 30});
    PosedBeams ping = kLevelPing;
    ping.north = 0.125 * i + 0.75, ping.east = -0.5;
    unwatched.beams().Add(i, ping, BeamEnds(ping.pose(), {4.4, 4.4, 4.4, 4.4}));
  }
  watched.beams().Shift(shift);
  unwatched.Paint({99, 2, 30}, kPaintedBelief);
  EXPECT_EQ(watched.Octree().Serialize(), unwatched.Octree().Serialize());
}

/// A seabed of one lane, as a former session left it.
SemanticOctree KnownGround() {
  SemanticMap map;
  for (int i = 0; i < 40; ++i) {
    LayPing(map, i, 0.1 * i);
  }
  map.Paint({3, 3, 3}, kPaintedBelief);
  Expected<SemanticOctree> octree = SemanticOctree::Parse(map.Octree().Serialize());
  return *std::move(octree);
}

TEST(SemanticMap, KeepsHalfOfWhatAFormerSessionKnewOfTheGroundAndNotItsObjects) {
  const SemanticOctree former = KnownGround();
  const Eigen::Vector3d seabed = CentreOf(EndOfFirstBeam(), 0.2);
  SemanticMap map;
  map.SetFormer(former);
  EXPECT_EQ(map.Octree().At(seabed)->occupied, 0.5F * former.At(seabed)->occupied);
  const Eigen::Vector3d end = BeamEnds(kLevelPing.pose(), {4.4, {}, {}, {}})[0].p_W;
  const auto water = map.Octree().At(0.5 * (kLevelPing.pose().p_WB + end));
  ASSERT_TRUE(water);
  EXPECT_LT(water->occupied, 0.0F);
  EXPECT_FALSE(map.Octree().At(CentreOf({3, 3, 3}, 0.2)));
}

TEST(SemanticMap, NewBeamsConfirmWhatIsThereAndOverruleWhatIsNot) {
  SemanticMap same, deeper, alone;
  for (SemanticMap* map : {&same, &deeper}) {
    map->SetFormer(KnownGround());
  }
  const Eigen::Vector3d seabed = CentreOf(EndOfFirstBeam(), 0.2);
  for (int i = 0; i < 6; ++i) {
    LayPing(same, i, 0.0);
    LayPing(alone, i, 0.0);
    PosedBeams ping = kLevelPing;
    ping.b1 = *ping.b1 + 0.6;
    deeper.beams().Add(i, ping, {{.p_W = seabed, .is_seabed = true, .beam = 0}});
  }
  EXPECT_GE(same.Octree().At(seabed)->occupied, alone.Octree().At(seabed)->occupied);
  EXPECT_LT(deeper.Octree().At(seabed)->occupied, 0.0F);
}

TEST(SemanticMap, LaysAFormerSessionWhereItsFrameTurnsOutToLie) {
  SemanticMap map;
  map.SetFormer(KnownGround());
  static_cast<void>(map.Octree().Serialize());
  map.SetFormerOffset({.shift_W = {2.0, -1.0}, .turn = 0.0, .pivot_W = {1.0, 1.0}, .down = 0.2});
  const Eigen::Vector3d seabed = CentreOf(EndOfFirstBeam(), 0.2);
  const Eigen::Vector3d there = seabed + Eigen::Vector3d(2.0, -1.0, 0.2);
  EXPECT_GT(map.Octree().At(there)->occupied, 0.0F);
  map.SetFormerOffset({});
  EXPECT_GT(map.Octree().At(seabed)->occupied, 0.0F);
  const std::string back = map.Octree().Serialize();
  SemanticMap untouched;
  untouched.SetFormer(KnownGround());
  EXPECT_EQ(back, untouched.Octree().Serialize());
}

TEST(SemanticMap, ASessionThatIsLoadedTwiceIsSavedAlike) {
  const auto saved = [] {
    SemanticMap map;
    map.SetFormer(KnownGround());
    map.SetFormerOffset({.shift_W = {0.3, 0.1}, .turn = 0.02, .pivot_W = {0.0, 0.0}, .down = 0.0});
    for (int i = 0; i < 20; ++i) {
      LayPing(map, i, 0.15 * i);
    }
    return map.Octree().Serialize();
  };
  EXPECT_EQ(saved(), saved());
}

TEST(SemanticMap, LeavesOutFormerLeavesThatNoBeamsCanHaveFilled) {
  SemanticOctree former(Meters(100.0));
  former.Set({50.0, 50.0, 50.0}, {.occupied = 2.0F});
  SemanticMap map;
  map.SetFormer(former);
  EXPECT_EQ(map.Octree().nodes(), 0U);
}

TEST(SemanticMap, EqualMapsGiveEqualBytesAndComeBackFromThem) {
  SemanticMap map;
  Random random(8);
  for (int i = 0; i < 200; ++i) {
    LayPing(map, i, random.Uniform(-5.0, 5.0));
  }
  const std::string bytes = map.Octree().Serialize();
  const Expected<SemanticOctree> loaded = SemanticOctree::Parse(bytes);
  ASSERT_TRUE(loaded) << loaded.error().text;
  EXPECT_EQ(loaded->At(CentreOf(EndOfFirstBeam(), 0.2)), map.At(EndOfFirstBeam()));
  EXPECT_EQ(loaded->Serialize(), bytes);
}

}  // namespace
}  // namespace limpet
