// SPDX-License-Identifier: MIT
#include "estimation/mapping/semantic_map.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "estimation/mapping/saved_map.hpp"
#include "limpet/core/random.hpp"
#include "tests/support/whole_map.hpp"

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
  EXPECT_EQ(WholeOctree(map).nodes(), 0U);
}

TEST(SemanticMap, BeamsDoNotTouchWhatIsKnownOfObjects) {
  SemanticMap map;
  map.Paint(EndOfFirstBeam(), kPaintedBelief);
  for (int i = 0; i < 50; ++i) {
    LayPing(map, i, 0.0);
  }
  EXPECT_EQ(map.At(EndOfFirstBeam()), kPaintedBelief);
  EXPECT_EQ(WholeOctree(map).At(CentreOf(EndOfFirstBeam(), 0.2)), kPaintedBelief);
}

TEST(SemanticMap, WhereAnObjectWasIsWhatBeamsSayAgain) {
  SemanticMap map;
  LayPing(map, 0.0, 0.0);
  const std::optional<VoxelBelief> ground = map.At(EndOfFirstBeam());
  ASSERT_TRUE(ground);
  EXPECT_GT(ground->occupied, 0.0F);
  map.Paint(EndOfFirstBeam(), kPaintedBelief);
  EXPECT_EQ(WholeOctree(map).At(CentreOf(EndOfFirstBeam(), 0.2)), kPaintedBelief);
  map.Unpaint(EndOfFirstBeam());
  EXPECT_EQ(WholeOctree(map).At(CentreOf(EndOfFirstBeam(), 0.2)), ground);
}

TEST(SemanticMap, ForgetsAnObjectWhereNoBeamHasBeen) {
  SemanticMap map;
  map.Paint({3, 3, 3}, kPaintedBelief);
  EXPECT_EQ(WholeOctree(map).nodes(), 17U);
  map.Unpaint({3, 3, 3});
  EXPECT_EQ(WholeOctree(map).nodes(), 0U);
}

TEST(SemanticMap, TheOctreeDoesNotDependOnWhenItWasReadNorOnHowTheTrackMoved) {
  const TrackShift shift{{{100.0, 0.75, -0.5, 0.0, 0.0}}};
  SemanticMap watched, unwatched;
  for (int i = 0; i < 100; ++i) {
    LayPing(watched, i, 0.125 * i);
    watched.Paint({i, 2, 30}, kPaintedBelief);
    if (i % 10 == 0) static_cast<void>(WholeOctree(watched).Serialize());
    watched.Unpaint({i - 1, 2, 30});
    PosedBeams ping = kLevelPing;
    ping.north = 0.125 * i + 0.75, ping.east = -0.5;
    unwatched.beams().Add(i, ping, BeamEnds(ping.pose(), {4.4, 4.4, 4.4, 4.4}));
  }
  watched.beams().Shift(shift);
  unwatched.Paint({99, 2, 30}, kPaintedBelief);
  EXPECT_EQ(WholeOctree(watched).Serialize(), WholeOctree(unwatched).Serialize());
}

void SetFormer(SemanticMap& map, const SemanticOctree& former) {
  const Expected<std::vector<MapTile>> tiles = TilesOf(former.Serialize());
  for (const MapTile& tile : *tiles) {
    const std::optional<Error> error = map.AddFormer(tile);
    EXPECT_FALSE(error) << error->text;
  }
}

/// A seabed of one lane, as a former session left it.
SemanticOctree KnownGround() {
  SemanticMap map;
  for (int i = 0; i < 40; ++i) {
    LayPing(map, i, 0.1 * i);
  }
  map.Paint({3, 3, 3}, kPaintedBelief);
  Expected<SemanticOctree> octree = SemanticOctree::Parse(WholeOctree(map).Serialize());
  return *std::move(octree);
}

TEST(SemanticMap, KeepsHalfOfWhatAFormerSessionKnewOfTheGroundAndNotItsObjects) {
  const SemanticOctree former = KnownGround();
  const Eigen::Vector3d seabed = CentreOf(EndOfFirstBeam(), 0.2);
  SemanticMap map;
  SetFormer(map, former);
  EXPECT_EQ(WholeOctree(map).At(seabed)->occupied, 0.5F * former.At(seabed)->occupied);
  const Eigen::Vector3d end = BeamEnds(kLevelPing.pose(), {4.4, {}, {}, {}})[0].p_W;
  const auto water = WholeOctree(map).At(0.5 * (kLevelPing.pose().p_WB + end));
  ASSERT_TRUE(water);
  EXPECT_LT(water->occupied, 0.0F);
  EXPECT_FALSE(WholeOctree(map).At(CentreOf({3, 3, 3}, 0.2)));
}

TEST(SemanticMap, NewBeamsConfirmWhatIsThereAndOverruleWhatIsNot) {
  SemanticMap same, deeper, alone;
  for (SemanticMap* map : {&same, &deeper}) {
    SetFormer(*map, KnownGround());
  }
  const Eigen::Vector3d seabed = CentreOf(EndOfFirstBeam(), 0.2);
  for (int i = 0; i < 6; ++i) {
    LayPing(same, i, 0.0);
    LayPing(alone, i, 0.0);
    PosedBeams ping = kLevelPing;
    ping.b1 = *ping.b1 + 0.6;
    deeper.beams().Add(i, ping, {{.p_W = seabed, .is_seabed = true, .beam = 0}});
  }
  EXPECT_GE(WholeOctree(same).At(seabed)->occupied, WholeOctree(alone).At(seabed)->occupied);
  EXPECT_LT(WholeOctree(deeper).At(seabed)->occupied, 0.0F);
}

TEST(SemanticMap, LaysAFormerSessionWhereItsFrameTurnsOutToLie) {
  SemanticMap map;
  SetFormer(map, KnownGround());
  static_cast<void>(WholeOctree(map).Serialize());
  map.SetFormerOffset({.shift_W = {2.0, -1.0}, .turn = 0.0, .pivot_W = {1.0, 1.0}, .down = 0.2});
  const Eigen::Vector3d seabed = CentreOf(EndOfFirstBeam(), 0.2);
  const Eigen::Vector3d there = seabed + Eigen::Vector3d(2.0, -1.0, 0.2);
  EXPECT_GT(WholeOctree(map).At(there)->occupied, 0.0F);
  map.SetFormerOffset({});
  EXPECT_GT(WholeOctree(map).At(seabed)->occupied, 0.0F);
  const std::string back = WholeOctree(map).Serialize();
  SemanticMap untouched;
  SetFormer(untouched, KnownGround());
  EXPECT_EQ(back, WholeOctree(untouched).Serialize());
}

TEST(SemanticMap, ASessionThatIsLoadedTwiceIsSavedAlike) {
  const auto saved = [] {
    SemanticMap map;
    SetFormer(map, KnownGround());
    map.SetFormerOffset({.shift_W = {0.3, 0.1}, .turn = 0.02, .pivot_W = {0.0, 0.0}, .down = 0.0});
    for (int i = 0; i < 20; ++i) {
      LayPing(map, i, 0.15 * i);
    }
    return WholeOctree(map).Serialize();
  };
  EXPECT_EQ(saved(), saved());
}

TEST(SemanticMap, RefusesAFormerTileThatItCannotLay) {
  SemanticOctree coarse(Meters(0.5)), elsewhere;
  coarse.Set({1.0, 1.0, 5.0}, {.occupied = 2.0F});
  elsewhere.Set({50.0, 1.0, 5.0}, {.occupied = 2.0F});
  SemanticMap map;
  const auto trouble = [&map](const SemanticOctree& octree) {
    return map.AddFormer(MapTile::Of({0, 0}, octree.Serialize())).value_or(Error{}).text;
  };
  EXPECT_EQ(trouble(coarse), "voxels of 0.5 m, where this mission's are of 0.2 m");
  EXPECT_EQ(trouble(elsewhere), "voxels outside its tile 0, 0");
  EXPECT_TRUE(map.AddFormer({.key = {0, 0}, .packed = "no gzip"}));
  EXPECT_EQ(WholeOctree(map).nodes(), 0U);
}

/// Twenty lanes, 40 m apart, then back to the first: of the rest no voxel is in memory meanwhile.
TEST(SemanticMap, IsTheSameMapHoweverLittleOfItIsInMemory) {
  constexpr std::size_t kTwoTiles = 200'000;
  SemanticMap small(Meters(0.2), {}, kTwoTiles), large;
  Random random(3);
  std::size_t most = 0;
  for (int i = 0; i < 2000; ++i) {
    PosedBeams ping = kLevelPing;
    ping.north = 40.0 * (i / 100 % 20) + random.Uniform(-3.0, 3.0);
    ping.yaw = random.Uniform(-3.0, 3.0);
    for (SemanticMap* map : {&small, &large})
      map->beams().Add(i, ping, BeamEnds(ping.pose(), {ping.b1, ping.b2, ping.b3, ping.b4}));
    most = std::max(most, small.beams().held_bytes());
    if (i % 500 != 0) continue;
    const TrackShift shift{{{0.0, 0.0, 0.0, 0.0, 0.0}, {i + 1.0, 0.5, 0.25, 0.0, 0.0}}};
    for (SemanticMap* map : {&small, &large})
      map->beams().Shift(shift);
  }
  EXPECT_EQ(WholeOctree(small).Serialize(), WholeOctree(large).Serialize());
  EXPECT_LT(most, 2 * kTwoTiles);
  EXPECT_GT(large.beams().held_bytes(), 5 * kTwoTiles);
  EXPECT_EQ(small.At(KeyOf({0.1, 0.1, 3.6}, 0.2)), large.At(KeyOf({0.1, 0.1, 3.6}, 0.2)));
}

TEST(SemanticMap, TellsWhichTilesAreOtherThanBefore) {
  SemanticMap map;
  LayPing(map, 0.0, 5.0);
  EXPECT_EQ(map.TakeChanged(), (std::vector<TileKey>{{0, -1}, {0, 0}}));
  EXPECT_TRUE(map.TakeChanged().empty());
  map.Paint({200, 2, 30}, kPaintedBelief);
  map.Unpaint({3, 2, 30});
  EXPECT_EQ(map.TakeChanged(), (std::vector<TileKey>{{3, 0}}));
  map.Unpaint({200, 2, 30});
  EXPECT_EQ(map.TakeChanged(), (std::vector<TileKey>{{3, 0}}));
  EXPECT_EQ(map.OctreeOf({3, 0}).nodes(), 0U);
  SetFormer(map, KnownGround());
  EXPECT_EQ(map.TakeChanged().size(), 4U);
  map.SetFormerOffset({.shift_W = {100.0, 0.0}, .turn = 0.0, .pivot_W = {0.0, 0.0}, .down = 0.0});
  EXPECT_GT(map.TakeChanged().size(), 4U);
}

TEST(SemanticMap, EqualMapsGiveEqualBytesAndComeBackFromThem) {
  SemanticMap map;
  Random random(8);
  for (int i = 0; i < 200; ++i) {
    LayPing(map, i, random.Uniform(-5.0, 5.0));
  }
  const std::string bytes = WholeOctree(map).Serialize();
  const Expected<SemanticOctree> loaded = SemanticOctree::Parse(bytes);
  ASSERT_TRUE(loaded) << loaded.error().text;
  EXPECT_EQ(loaded->At(CentreOf(EndOfFirstBeam(), 0.2)), map.At(EndOfFirstBeam()));
  EXPECT_EQ(loaded->Serialize(), bytes);
}

}  // namespace
}  // namespace limpet
