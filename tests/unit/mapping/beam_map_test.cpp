// SPDX-License-Identifier: MIT
#include "estimation/mapping/beam_map.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "limpet/core/random.hpp"

namespace limpet {
namespace {

constexpr Meters kMapVoxel(0.2);
constexpr double kRecordedSpan = 60.0;  // of a flight [s]

/// In steps that floats can hold and add, so that both ways to a corrected track meet exactly.
double Dyadic(double value) { return std::round(value * 256.0) / 256.0; }

struct TimedPing {
  double t = 0.0;
  PosedBeams beams;
};

/// Five pings a second along a wavy way above an uneven bottom.
std::vector<TimedPing> RecordedPings() {
  Random random(5);
  std::vector<TimedPing> pings;
  for (double t = 0.0; t < kRecordedSpan; t += 0.25) {
    const auto range = [&] { return std::optional(4.4 + random.Uniform(-0.2, 0.2)); };
    pings.push_back({.t = t,
                     .beams = {.north = Dyadic(0.5 * t),
                               .east = Dyadic(3.0 * std::sin(0.1 * t)),
                               .down = 3.5,
                               .roll = Dyadic(random.Uniform(-0.05, 0.05)),
                               .pitch = Dyadic(random.Uniform(-0.05, 0.05)),
                               .yaw = Dyadic(random.Uniform(-1.0, 1.0)),
                               .b1 = range(),
                               .b2 = range(),
                               .b3 = range(),
                               .b4 = random.Uniform(0.0, 1.0) < 0.9 ? range() : std::nullopt,
                               .sd_down = {}}});
  }
  return pings;
}

void AddTo(BeamMap& map, const TimedPing& ping) {
  const PosedBeams& beams = ping.beams;
  const std::vector<BeamEnd> ends =
      BeamEnds(beams.pose(), {beams.b1, beams.b2, beams.b3, beams.b4});
  EXPECT_EQ(map.Add(ping.t, beams, ends), static_cast<int>(ends.size()));
}

BeamMap MapOf(const std::vector<TimedPing>& pings) {
  BeamMap map(kMapVoxel);
  for (const TimedPing& ping : pings) {
    AddTo(map, ping);
  }
  return map;
}

std::vector<TimedPing> Moved(std::vector<TimedPing> pings, const TrackShift& shift) {
  for (TimedPing& ping : pings) {
    const Pose X_WD = shift.Apply(ping.t, ping.beams.pose());
    ping.beams.north = X_WD.p_WB.x(), ping.beams.east = X_WD.p_WB.y();
    ping.beams.down = X_WD.p_WB.z(), ping.beams.yaw = X_WD.yaw;
  }
  return pings;
}

std::map<VoxelKey, VoxelCounts> VoxelsOf(const BeamMap& map) {
  std::map<VoxelKey, VoxelCounts> voxels;
  for (const TileKey& tile : map.Tiles()) {
    map.ForEachKnown(tile,
                     [&](const VoxelKey& key, const VoxelCounts& counts) { voxels[key] = counts; });
  }
  return voxels;
}

/// Steps a power of two apart, so that what lies between is exact, too.
TrackShift RandomShift(Random& random) {
  TrackShift shift;
  const double until = random.Uniform(16.0, kRecordedSpan);
  for (double t = 0.0; t <= until; t += 4.0) {
    const auto part = [&](double most) {
      return Dyadic(0.125 * random.Uniform(-most, most)) * 8.0;
    };
    shift.steps.push_back({t, part(0.6), part(0.6), part(0.2), part(0.06)});
  }
  return shift;
}

TEST(BeamMap, AfterShiftsIsVoxelForVoxelTheMapOfTheCorrectedTrack) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    std::vector<TimedPing> track = RecordedPings();
    BeamMap map = MapOf(track);
    for (int i = 0; i < 3; ++i) {
      const TrackShift shift = RandomShift(random);
      map.Shift(shift);
      track = Moved(track, shift);
    }
    map.SettleAll();
    // A ping that moved less than kStays may be behind: none of these does.
    const BeamMap corrected = MapOf(track);
    EXPECT_EQ(VoxelsOf(map), VoxelsOf(corrected)) << "seed " << seed;
    EXPECT_EQ(map.depths().Serialize(), corrected.depths().Serialize()) << "seed " << seed;
  }
}

TEST(BeamMap, LaysAgainInBoundedStepsWhatOneStepWould) {
  Random random(3);
  const TrackShift first = RandomShift(random), second = RandomShift(random);
  BeamMap stepwise = MapOf(RecordedPings()), at_once = MapOf(RecordedPings());
  int ticks = 1;
  stepwise.Shift(first);
  static_cast<void>(stepwise.Settle(500));
  stepwise.Shift(second);  // while the first is on its way
  for (; !stepwise.Settle(500); ++ticks) {
  }
  at_once.Shift(first);
  at_once.SettleAll();
  at_once.Shift(second);
  at_once.SettleAll();
  EXPECT_GT(ticks, 20) << "five pings a tick";
  EXPECT_EQ(VoxelsOf(stepwise), VoxelsOf(at_once));
}

TEST(BeamMap, LeavesPingsThatCameAfterTheShiftOrBeforeItBegins) {
  const std::vector<TimedPing> track = RecordedPings();
  const std::size_t half = track.size() / 2;
  BeamMap map = MapOf({track.begin(), track.begin() + static_cast<std::ptrdiff_t>(half)});
  const double now = track[half - 1].t;
  const TrackShift shift{{{now - 8.0, 0.0, 0.0, 0.0, 0.0}, {now, 1.0, 0.0, 0.0, 0.0}}};
  map.Shift(shift);
  std::vector<TimedPing> corrected = track;
  for (std::size_t i = 0; i < half; ++i) {
    corrected[i] = Moved({track[i]}, shift)[0];
  }
  for (std::size_t i = half; i < track.size(); ++i) {
    AddTo(map, track[i]);
  }
  map.SettleAll();
  EXPECT_EQ(VoxelsOf(map), VoxelsOf(MapOf(corrected)));
}

TEST(BeamMap, SmallStepsAddUpUntilTheyAreWorthIt) {
  constexpr double kSmall = 0.0078125;
  static_assert(kSmall < BeamMap::kStays && 2.0 * kSmall > BeamMap::kStays);
  const TrackShift step{{{kRecordedSpan, kSmall, 0.0, 0.0, 0.0}}};
  const TrackShift both{{{kRecordedSpan, 2.0 * kSmall, 0.0, 0.0, 0.0}}};
  BeamMap map = MapOf(RecordedPings());
  const auto before = VoxelsOf(map);
  map.Shift(step);
  map.SettleAll();
  EXPECT_EQ(VoxelsOf(map), before);
  map.Shift(step);
  map.SettleAll();
  EXPECT_EQ(VoxelsOf(map), VoxelsOf(MapOf(Moved(RecordedPings(), both))));
}

TEST(BeamMap, DepthsAreOfTheSeabedAloneAndSayHowWellTheVehicleKnewItsOwn) {
  BeamMap map(kMapVoxel);
  const double slant = 4.0 / std::cos(DvlBeams{}.from_vertical.value());
  PosedBeams ping{
      .down = 3.5, .b1 = slant, .b2 = slant, .b3 = slant, .b4 = 0.6 * slant, .sd_down = 0.3};
  const std::vector<BeamEnd> ends = BeamEnds(ping.pose(), {ping.b1, ping.b2, ping.b3, ping.b4});
  ASSERT_EQ(ends.size(), 4U);
  map.Add(0.0, ping, ends);
  ping.sd_down = 0.4;
  map.Add(1.0, ping, ends);
  const std::vector<DepthColumn> columns = map.depths().Columns();
  ASSERT_EQ(columns.size(), 3U) << "the fourth beam ends on an object";
  for (const DepthColumn& column : columns) {
    EXPECT_NEAR(column.down, 7.5, 1e-3);
    EXPECT_EQ(column.beams, 2U);
  }
  EXPECT_NEAR(map.depths().zero_sigma(), std::sqrt(0.125), 1e-9);
}

TEST(BeamMap, DoesNotTakeWhatIsTooFarAwayNorGoesThereByAShift) {
  BeamMap map(kMapVoxel);
  TimedPing far = RecordedPings().front();
  far.beams.north = 7000.0;
  const std::vector<BeamEnd> ends = BeamEnds(far.beams.pose(), {4.4, {}, {}, {}});
  EXPECT_EQ(map.Add(far.t, far.beams, ends), 0);
  EXPECT_TRUE(VoxelsOf(map).empty());
  for (const double shift : {1e300, std::numeric_limits<double>::quiet_NaN()}) {
    BeamMap thrown = MapOf(RecordedPings());
    thrown.Shift({{{kRecordedSpan, shift, 0.0, 0.0, 0.0}}});
    thrown.SettleAll();
    EXPECT_TRUE(VoxelsOf(thrown).empty());
  }
}

}  // namespace
}  // namespace limpet
