// SPDX-License-Identifier: MIT
// Ends of beams over planes and objects, from any pose.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

#include "estimation/mapping/dvl_beams.hpp"
#include "limpet/core/random.hpp"

namespace limpet {
namespace {

/// Unit vector of a beam in the world, by its definition.
Eigen::Vector3d BeamAxis(const Pose& X_WD, std::size_t beam, const DvlBeams& dvl) {
  const double azimuth =
      dvl.yaw.value() + (0.25 + 0.5 * static_cast<double>(beam)) * std::numbers::pi;
  const double tilt = dvl.from_vertical.value();
  return RotationOf(X_WD) * Eigen::Vector3d(std::sin(tilt) * std::cos(azimuth),
                                            std::sin(tilt) * std::sin(azimuth), std::cos(tilt));
}

class BeamEndsProperties : public ::testing::TestWithParam<int> {
 protected:
  /// Slant ranges to a level seabed at depth `kDown`.
  [[nodiscard]] std::array<std::optional<double>, 4> ToSeabed() const {
    std::array<std::optional<double>, 4> ranges;
    for (std::size_t beam = 0; beam < 4; ++beam)
      ranges[beam] = (kDown - X_WD_.p_WB.z()) / BeamAxis(X_WD_, beam, dvl_).z();
    return ranges;
  }
  static constexpr double kDown = 12.0;
  Random random_{static_cast<std::uint64_t>(GetParam()), "beams"};
  const DvlBeams dvl_{.yaw = Radians(random_.Uniform(-3.1, 3.1)),
                      .from_vertical = Radians(random_.Uniform(0.2, 0.6))};
  const Pose X_WD_{{random_.Normal(20.0), random_.Normal(20.0), random_.Uniform(2.0, 9.0)},
                   random_.Uniform(-0.15, 0.15),
                   random_.Uniform(-0.15, 0.15),
                   random_.Uniform(-3.1, 3.1)};
};

TEST_P(BeamEndsProperties, ALevelSeabedIsLevelFromATiltedVehicle) {
  const auto ends = BeamEnds(X_WD_, ToSeabed(), 3.0, dvl_);
  ASSERT_EQ(ends.size(), 4U);
  for (const BeamEnd& end : ends) {
    EXPECT_NEAR(end.p_W.z(), kDown, 1e-9);
    EXPECT_TRUE(end.is_seabed);
  }
}

TEST_P(BeamEndsProperties, EachEndLiesAlongItsOwnBeam) {
  const auto ranges = ToSeabed();
  const auto ends = BeamEnds(X_WD_, ranges, 3.0, dvl_);
  ASSERT_EQ(ends.size(), 4U);
  for (std::size_t beam = 0; beam < 4; ++beam) {
    const Eigen::Vector3d there = X_WD_.p_WB + *ranges[beam] * BeamAxis(X_WD_, beam, dvl_);
    EXPECT_LT((ends[beam].p_W - there).norm(), 1e-9);
  }
}

TEST_P(BeamEndsProperties, ABeamStoppedByAnObjectIsNoSeabedAndOneTooHighNothing) {
  for (std::size_t beam = 0; beam < 4; ++beam) {
    const double down_per_metre = BeamAxis(X_WD_, beam, dvl_).z();
    const double altitude = kDown - X_WD_.p_WB.z();
    auto ranges = ToSeabed();
    *ranges[beam] -= 0.5 / down_per_metre;  // half a metre above the bottom
    auto ends = BeamEnds(X_WD_, ranges, 3.0, dvl_);
    ASSERT_EQ(ends.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(ends[i].is_seabed, i != beam);
    if (altitude < 4.0) continue;  // no room above objects of a metre
    ranges = ToSeabed();
    *ranges[beam] -= std::max(1.1, 0.36 * altitude) / down_per_metre;
    EXPECT_EQ(BeamEnds(X_WD_, ranges, 1.0, dvl_).size(), 3U);
  }
}

TEST_P(BeamEndsProperties, ABeamThatGoesBelowTheBottomIsLeftOut) {
  const double altitude = kDown - X_WD_.p_WB.z();
  for (std::size_t beam = 0; beam < 4; ++beam) {
    auto ranges = ToSeabed();
    *ranges[beam] += std::max(1.1, 0.36 * altitude) / BeamAxis(X_WD_, beam, dvl_).z();
    EXPECT_EQ(BeamEnds(X_WD_, ranges, 3.0, dvl_).size(), 3U);
  }
}

TEST_P(BeamEndsProperties, ALostBeamTakesNoOtherWithIt) {
  for (std::size_t beam = 0; beam < 4; ++beam) {
    auto ranges = ToSeabed();
    ranges[beam].reset();
    const auto ends = BeamEnds(X_WD_, ranges, 3.0, dvl_);
    ASSERT_EQ(ends.size(), 3U);
    for (const BeamEnd& end : ends)
      EXPECT_TRUE(end.is_seabed);
  }
}

TEST_P(BeamEndsProperties, RangesThatNoDvlMeasuresAreLeftOut) {
  auto ranges = ToSeabed();
  ranges[0] = 0.19, ranges[2] = 100.1;
  EXPECT_EQ(BeamEnds(X_WD_, ranges, 3.0, dvl_).size(), 2U);
}

INSTANTIATE_TEST_SUITE_P(Drawn, BeamEndsProperties, ::testing::Range(1, 13));

}  // namespace
}  // namespace limpet
