// SPDX-License-Identifier: MIT
#include "limpet/planning/sweep_memory.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"
#include "tests/unit/planning/search_scene.hpp"

namespace limpet {
namespace {

struct Motion {
  Pose2 from;
  PathSegment segment;
};

std::vector<Motion> RandomMotions(int count) {
  Random random(9);
  std::vector<Motion> motions;
  for (int i = 0; i < count; ++i) {
    const Pose2 from{random.Uniform(-16.0, 16.0), random.Uniform(-19.0, 19.0),
                     random.Uniform(-3.0, 3.0)};
    const double curvature = random.Chance(0.5) ? 0.0 : (random.Chance(0.5) ? 1.0 : -1.0) / 3.0;
    motions.push_back({from, {.curvature = curvature, .length = random.Uniform(0.0, 25.0)}});
  }
  return motions;
}

/// Counts of cells that are unseen after each piece, as the memory says.
std::vector<SeenPlanes::Counts> CountsOf(const SweptMotion& motion, SeenPlanes& planes) {
  std::vector<SeenPlanes::Counts> counts;
  for (std::size_t i = 0; i < motion.pieces.size(); ++i) {
    for (std::size_t plane = 0; plane < SeenPlanes::kPlanes; ++plane) {
      planes.See(plane, motion.ShownBy(i, plane));
    }
    counts.push_back(planes.unseen());
  }
  return counts;
}

/// And as sweeping the pieces themselves does.
std::vector<SeenPlanes::Counts> CountsSwept(const SweptMotion& motion, SeenPlanes& planes) {
  std::vector<SeenPlanes::Counts> counts;
  for (const SweptMotion::Piece& piece : motion.pieces) {
    planes.Sweep(piece.from, piece.motion);
    counts.push_back(planes.unseen());
  }
  return counts;
}

TEST(SweepMemory, ShowsPieceByPieceWhatSweepingDoesWhateverHasBeenSeenBefore) {
  const scene::HalfSeen half;
  SweepMemory memory(half.ground);
  SeenPlanes told(half.ground), swept(half.ground);
  const std::vector<Motion> motions = RandomMotions(30);
  for (int time = 0; time < 2; ++time) {  // the second time it remembers them
    told.Reset(half.ground), swept.Reset(half.ground);
    for (const auto& [from, segment] : motions) {
      const SweptMotion& motion = memory.Of(from, segment);
      ASSERT_EQ(CountsOf(motion, told), CountsSwept(motion, swept));
    }
  }
  EXPECT_LT(told.unseen()[SeenPlanes::kTop],
            SeenPlanes(half.ground).unseen()[SeenPlanes::kTop] / 2);
}

TEST(SweepMemory, CutsMotionsIntoPiecesThatFollowOneAnother) {
  const scene::HalfSeen half;
  SweepMemory memory(half.ground);
  for (const auto& [from, segment] : RandomMotions(20)) {
    const SweptMotion& motion = memory.Of(from, segment);
    Pose2 at = from;
    for (const SweptMotion::Piece& piece : motion.pieces) {
      ASSERT_LT(Distance(at, piece.from), 1e-9);
      ASSERT_LE(piece.motion.length, segment.curvature == 0.0 ? 4.0 : 2.0);
      at = Advance(at, piece.motion);
    }
    ASSERT_LT(Distance(at, Advance(from, segment)), 1e-9);
  }
}

/// Ground that has been seen since is no longer shown, and none of what was known is told.
TEST(SweepMemory, ForgetsAllWhenTheGroundHasChanged) {
  scene::HalfSeen half;
  SweepMemory memory(half.ground);
  const Pose2 from{0.0, -15.0, 0.5 * std::numbers::pi};
  const PathSegment segment{.curvature = 0.0, .length = 30.0};
  ASSERT_FALSE(memory.Of(from, segment).shown[SeenPlanes::kTop].empty());
  scene::Fly(half.grid, DubinsPath(from, {segment}));
  half.ground.Update(half.grid);
  memory.Reset(half.ground);
  SeenPlanes planes(half.ground);
  const int before = planes.unseen()[SeenPlanes::kTop];
  const SweptMotion& motion = memory.Of(from, segment);
  CountsOf(motion, planes);
  EXPECT_EQ(planes.unseen()[SeenPlanes::kTop], before);
  EXPECT_TRUE(motion.shown[SeenPlanes::kTop].empty());
}

}  // namespace
}  // namespace limpet
