// SPDX-License-Identifier: MIT
#include "estimation/mapping/ground_looks.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/whole_map.hpp"

namespace limpet {
namespace {

const LookModel kLookModel{};
constexpr double kGroundDown = 7.5;

/// A seabed of 6 by 6 m, known everywhere.
SemanticMap KnownSeabed() {
  SemanticMap map;
  const double slant = 2.0;
  const PosedBeams ping{
      .down = kGroundDown - slant, .b1 = slant, .b2 = {}, .b3 = {}, .b4 = {}, .sd_down = {}};
  const DvlBeams dvl;
  const Eigen::Vector3d along = BeamDirections(dvl)[0];
  double t = 0.0;
  for (double north = -3.0; north < 3.0; north += 0.2) {
    for (double east = -3.0; east < 3.0; east += 0.2) {
      PosedBeams here = ping;
      here.north = north + 0.1 - slant * along.x(), here.east = east + 0.1 - slant * along.y();
      here.down = kGroundDown - slant * along.z() + 0.05;
      const Eigen::Vector3d end_W = here.pose().p_WB + slant * along;
      map.beams().Add(t += 1.0, here, {{.p_W = end_W, .is_seabed = true, .beam = 0}});
    }
  }
  return map;
}

ObservedFrame FrameAt(double t, double north, double down = 3.5) {
  return {.exposure = Seconds(t), .X_WB = {{north, 0.0, down}}, .altitude = kGroundDown - down};
}

VoxelKey GroundAtPlace(double north, double east) {
  return KeyOf({north, east, kGroundDown + 0.05}, 0.2);
}

float OddsAt(const std::vector<ObservedFrame>& frames, double north,
             const SemanticMap& map = KnownSeabed(), const LookModel& model = kLookModel) {
  GroundLooks looks(model, {});
  while (!looks.Settle(frames, map)) {
  }
  return looks.LogOdds(GroundAtPlace(north, 0.1));
}

TEST(GroundLooks, GroundThatNobodyLookedAtMayBeAnything) {
  EXPECT_EQ(OddsAt({}, 0.1), 0.0F);
  EXPECT_EQ(OddsAt({FrameAt(0.0, 40.0)}, 0.1), 0.0F);
}

TEST(GroundLooks, GroundInAnImageWithoutBoxesIsNoObjects) {
  EXPECT_LT(OddsAt({FrameAt(0.0, 0.0)}, 0.1), -2.0F);
}

TEST(GroundLooks, LooksOfOnePassAreOneWitnessAndAnotherPassIsAnother) {
  const float one = OddsAt({FrameAt(0.0, 0.0)}, 0.1);
  EXPECT_EQ(OddsAt({FrameAt(0.0, 0.0), FrameAt(0.25, 0.1)}, 0.1), one);
  EXPECT_NEAR(OddsAt({FrameAt(0.0, 0.0), FrameAt(1.0, 0.5)}, 0.1), one, 0.5);
  EXPECT_LT(OddsAt({FrameAt(0.0, 0.0), FrameAt(60.0, 0.6)}, 0.1), one - 0.4);
}

TEST(GroundLooks, WhatABoxCoversIsNotSaidToBeGround) {
  ObservedFrame frame = FrameAt(0.0, 0.0);
  const auto pixel =
      *kLookModel.camera.Project(kLookModel.camera.InCamera(frame.X_WB, {0.1, 0.1, kGroundDown}));
  frame.boxes = {
      {.u = pixel.x(), .v = pixel.y(), .w = 90.0, .h = 90.0, .confidence = 0.9, .color = {}}};
  EXPECT_EQ(OddsAt({frame}, 0.1), 0.0F);
  EXPECT_LT(OddsAt({frame}, -1.5), -2.0F) << "beside it";
}

TEST(GroundLooks, WhatStandsInFrontHidesWhatIsBehind) {
  SemanticMap map = KnownSeabed();
  for (int i = -2; i <= 2; ++i) {
    for (int j = -2; j <= 2; ++j) {
      map.Paint({i, j, 28}, {.occupied = 2.0F, .object = 2.0F, .label = VoxelLabel::kNew});
    }
  }
  EXPECT_EQ(OddsAt({FrameAt(0.0, 0.0)}, 0.1, map), 0.0F);
  EXPECT_LT(OddsAt({FrameAt(0.0, 0.0)}, 1.7, map), -2.0F);
}

TEST(GroundLooks, WhatIsTooFarAwayInThisWaterWasNotSeen) {
  LookModel murky = kLookModel;
  murky.detection.visibility = Meters(2.0);
  const SemanticMap map = KnownSeabed();
  EXPECT_EQ(OddsAt({FrameAt(0.0, 0.0)}, 0.1, map, murky), 0.0F);
  GroundLooks looks(murky, {});
  const std::vector<ObservedFrame> frames{FrameAt(0.0, 0.0)};
  EXPECT_TRUE(looks.Settle(frames, map));
  looks.SetModel(kLookModel);
  while (!looks.Settle(frames, map)) {
  }
  EXPECT_LT(looks.LogOdds(GroundAtPlace(0.1, 0.1)), -2.0F) << "the water turned out clear";
}

TEST(GroundLooks, FramesThatMovedAreGoneThroughAgainBesideWhatIsKnown) {
  const SemanticMap map = KnownSeabed();
  GroundLooks looks(kLookModel, {});
  std::vector<ObservedFrame> frames;
  for (int i = 0; i < 10; ++i) {
    frames.push_back(FrameAt(10.0 * i, 0.0 + 0.6 * (i % 2)));
  }
  while (!looks.Settle(frames, map)) {
  }
  const float before = looks.LogOdds(GroundAtPlace(0.1, 0.1));
  for (ObservedFrame& frame : frames) {
    frame.X_WB.p_WB.x() += 3.5;
  }
  EXPECT_FALSE(looks.TakeChanged().empty());
  EXPECT_TRUE(looks.TakeChanged().empty());
  looks.BeginAnew();
  EXPECT_FALSE(looks.Settle(frames, map, 1));
  EXPECT_EQ(looks.LogOdds(GroundAtPlace(0.1, 0.1)), before);
  EXPECT_TRUE(looks.TakeChanged().empty()) << "not told yet";
  while (!looks.Settle(frames, map)) {
  }
  EXPECT_TRUE(looks.TakeChanged().contains(TileOf(GroundAtPlace(0.1, 0.1))));
  EXPECT_EQ(looks.LogOdds(GroundAtPlace(0.1, 0.1)), 0.0F);
}

TEST(GroundLooks, AreInTheOctreeWhereItIsOccupiedAndNoObject) {
  SemanticMap map = KnownSeabed();
  const VoxelBelief object{.occupied = 2.0F, .object = 2.0F, .label = VoxelLabel::kNew};
  map.Paint(GroundAtPlace(0.1, 0.1), object);
  const auto odds = [](const VoxelKey& key) { return key[0] == 5 ? -3.0F : 0.0F; };
  const SemanticOctree octree = WholeOctree(map, odds);
  EXPECT_EQ(octree.At(CentreOf(GroundAtPlace(1.1, 0.1), 0.2))->object, -3.0F);
  EXPECT_EQ(octree.At(CentreOf(GroundAtPlace(1.3, 0.1), 0.2))->object, 0.0F);
  EXPECT_EQ(octree.At(CentreOf(GroundAtPlace(0.1, 0.1), 0.2))->object, 2.0F);
  EXPECT_EQ(octree.At({1.1, 0.1, 6.9})->object, 0.0F) << "water";
  EXPECT_EQ(WholeOctree(map, odds).Serialize(), WholeOctree(map, odds).Serialize());
}

}  // namespace
}  // namespace limpet
