// SPDX-License-Identifier: MIT
#include "estimation/mapping/dvl_beams.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace limpet {
namespace {

const double kSlant = 4.0 / std::cos(25.0 * std::numbers::pi / 180.0);
const Pose kPose{{10.0, 20.0, 3.5}, 0.0, 0.0, 0.0};

TEST(BeamEnds, LieOnAFlatSeabed) {
  const std::vector<BeamEnd> ends = BeamEnds(kPose, {kSlant, kSlant, kSlant, kSlant});
  ASSERT_EQ(ends.size(), 4U);
  for (const BeamEnd& end : ends) {
    EXPECT_NEAR(end.p_W.z(), 7.5, 1e-9);
    EXPECT_TRUE(end.is_seabed);
  }
}

TEST(BeamEnds, TheFirstBeamLooksForwardAndStarboard) {
  const std::vector<BeamEnd> ends = BeamEnds(kPose, {kSlant, {}, {}, {}});
  ASSERT_EQ(ends.size(), 1U);
  const double out = 4.0 * std::tan(25.0 * std::numbers::pi / 180.0) / std::sqrt(2.0);
  EXPECT_NEAR(ends[0].p_W.x(), 10.0 + out, 1e-9);
  EXPECT_NEAR(ends[0].p_W.y(), 20.0 + out, 1e-9);
}

TEST(BeamEnds, ABeamThatHitsAnObjectIsNotTheSeabed) {
  const std::vector<BeamEnd> ends = BeamEnds(kPose, {0.6 * kSlant, kSlant, kSlant, kSlant});
  ASSERT_EQ(ends.size(), 4U);
  EXPECT_FALSE(ends[0].is_seabed);
  EXPECT_TRUE(ends[1].is_seabed);
}

TEST(BeamEnds, LeavesOutliersOut) {
  EXPECT_EQ(BeamEnds(kPose, {2.0 * kSlant, kSlant, kSlant, kSlant}).size(), 3U);
  EXPECT_EQ(BeamEnds(kPose, {0.05, kSlant, kSlant, kSlant}).size(), 3U);
}

TEST(BeamEnds, SaysNothingWithoutBeams) { EXPECT_TRUE(BeamEnds(kPose, {}).empty()); }

}  // namespace
}  // namespace limpet
