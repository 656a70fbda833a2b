// SPDX-License-Identifier: MIT
#include "estimation/mapping/dvl_beams.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

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

TEST(BeamEnds, KeepsABeamOnTopOfAnObjectAsTallAsTheMissionSays) {
  const Pose high{{0.0, 0.0, 0.0}, 0.0, 0.0, 0.0};
  const std::array<std::optional<double>, 4> ranges{1.0 * kSlant, 2.5 * kSlant, 2.5 * kSlant,
                                                    2.5 * kSlant};
  EXPECT_EQ(BeamEnds(high, ranges).size(), 3U) << "6 m above the seabed";
  EXPECT_EQ(BeamEnds(high, ranges, 6.5).size(), 4U);
}

TEST(BeamEnds, KeepsAllBeamsOnASlopeOfTwentyFiveDegrees) {
  const Pose high{{0.0, 0.0, 0.0}, 0.0, 0.0, 0.0};
  std::array<std::optional<double>, 4> ranges;
  for (std::size_t i = 0; i < 4; ++i) {  // plane: depth = 10 + tan(25 deg) * north
    const double tilt = 25.0 * std::numbers::pi / 180.0;
    const double azimuth = (45.0 + 90.0 * static_cast<double>(i)) * std::numbers::pi / 180.0;
    const double out = std::sin(tilt) * std::cos(azimuth);
    ranges[i] = 10.0 / (std::cos(tilt) - std::tan(tilt) * out);
  }
  EXPECT_EQ(BeamEnds(high, ranges).size(), 4U);
}

TEST(BeamEnds, SaysNothingWithoutBeams) { EXPECT_TRUE(BeamEnds(kPose, {}).empty()); }

TEST(BeamEnds, ATurnedDvlsFirstBeamLooksElsewhere) {
  const DvlBeams turned{.yaw = Radians::FromTextUnit(90.0)};
  const std::vector<BeamEnd> ends = BeamEnds(kPose, {kSlant, {}, {}, {}}, 3.0, turned);
  const std::vector<BeamEnd> second = BeamEnds(kPose, {std::nullopt, kSlant, {}, {}});
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_TRUE(ends[0].p_W.isApprox(second[0].p_W));
}

TEST(BeamEnds, ReachFartherOutWithWiderBeams) {
  const DvlBeams wide{.from_vertical = Radians::FromTextUnit(30.0)};
  const std::vector<BeamEnd> ends = BeamEnds(kPose, {kSlant, {}, {}, {}}, 3.0, wide);
  const std::vector<BeamEnd> usual = BeamEnds(kPose, {kSlant, {}, {}, {}});
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_GT((ends[0].p_W - kPose.p_WB).head<2>().norm(),
            (usual[0].p_W - kPose.p_WB).head<2>().norm());
}

}  // namespace
}  // namespace limpet
