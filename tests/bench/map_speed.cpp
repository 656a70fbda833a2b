// SPDX-License-Identifier: MIT
// map_speed: what it costs to lay DVL beams into the map, beside OctoMap's own insertRay on the
// same beams in the same run, and what an update costs while the smoother keeps moving the way
// behind. Times are of this thread's processor.
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <octomap/OcTree.h>

#include "estimation/mapping/anchored_grid.hpp"
#include "estimation/mapping/ground_looks.hpp"
#include "estimation/mapping/map_params.hpp"
#include "estimation/mapping/semantic_map.hpp"
#include "limpet/core/clock.hpp"
#include "limpet/core/random.hpp"
#include "limpet/core/statistics.hpp"

namespace {

using namespace limpet;

constexpr double kVoxel = 0.2;
constexpr double kHertz = 8.0;
constexpr double kTick = 0.25;  ///< pMap's [s]
constexpr double kAltitude = 4.0;
const SurveyArea kArea{.north_min = 0.0,
                       .north_max = 36.0,
                       .east_min = 0.0,
                       .east_max = 28.0,
                       .margin = 2.0,
                       .object_height_max = 2.0};

struct TimedPing {
  double t = 0.0;
  PosedBeams beams;
  std::vector<BeamEnd> ends;
};

/// Lanes 4 m apart and 36 m long at 0.5 m/s, 4 m above a gently waving seabed, over and over.
std::vector<TimedPing> Survey(double duration_s) {
  constexpr double kSpeed = 0.5, kLane = 36.0, kApart = 4.0, kSeabed = 7.5;
  constexpr int kLanes = 8;
  Random random(1);
  std::vector<TimedPing> pings;
  for (double t = 0.0; t < duration_s; t += 1.0 / kHertz) {
    const double way = kSpeed * t;
    const int lane = static_cast<int>(way / kLane);
    const double along = way - lane * kLane;
    TimedPing ping{.t = t, .beams = {}, .ends = {}};
    PosedBeams& beams = ping.beams;
    beams.north = lane % 2 == 0 ? along : kLane - along;
    beams.east = kApart * (lane % kLanes);
    beams.down = kSeabed - kAltitude;
    beams.yaw = lane % 2 == 0 ? 0.0 : 3.1;
    beams.roll = random.Normal(0.01), beams.pitch = random.Normal(0.01);
    const auto slant = [&] {
      return std::optional(kAltitude / std::cos(DvlBeams{}.from_vertical.value()) +
                           0.05 * std::sin(0.3 * way) + random.Normal(0.02));
    };
    beams.b1 = slant(), beams.b2 = slant(), beams.b3 = slant(), beams.b4 = slant();
    ping.ends = BeamEnds(beams.pose(), {beams.b1, beams.b2, beams.b3, beams.b4});
    pings.push_back(std::move(ping));
  }
  return pings;
}

octomap::point3d PointOf(const Eigen::Vector3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

double SecondsOfOctoMap(const std::vector<TimedPing>& pings) {
  octomap::OcTree tree(kVoxel);
  const double start = ThreadTime().value();
  for (const TimedPing& ping : pings) {
    for (const BeamEnd& end : ping.ends) {
      tree.insertRay(PointOf(ping.beams.pose().p_WB), PointOf(end.p_W));
    }
  }
  return ThreadTime().value() - start;
}

double SecondsOfOurs(const std::vector<TimedPing>& pings) {
  BeamMap map{Meters(kVoxel)};
  const double start = ThreadTime().value();
  for (const TimedPing& ping : pings) {
    map.Add(ping.t, ping.beams, ping.ends);
  }
  return ThreadTime().value() - start;
}

void CompareInsertion() {
  constexpr int kRounds = 5;
  const std::vector<TimedPing> pings = Survey(1200.0);
  double beams = 0.0;
  for (const TimedPing& ping : pings) {
    beams += static_cast<double>(ping.ends.size());
  }
  std::vector<double> theirs, ours, ratios;
  for (int round = 0; round < kRounds; ++round) {
    const double of_octomap = SecondsOfOctoMap(pings), of_ours = SecondsOfOurs(pings);
    theirs.push_back(beams / of_octomap);
    ours.push_back(beams / of_ours);
    ratios.push_back(of_octomap / of_ours);
  }
  fmt::print("{:.0f} beams, voxels of {} m, median of {} rounds\n", beams, kVoxel, kRounds);
  fmt::print("OctoMap insertRay {:.0f} beams/s, ours {:.0f} beams/s: {:.1f} times (least {:.1f})\n",
             Quantile(theirs, 0.5), Quantile(ours, 0.5), Quantile(ratios, 0.5),
             Quantile(ratios, 0.0));
}

/// A loop closed: all of the way so far turns a little and moves by up to 0.3 m.
TrackShift LoopClosed(double now) {
  TrackShift shift;
  for (double t = 0.0; t < now; t += 5.0) {
    const double share = t / now;
    shift.steps.push_back({t, 0.2 * share, -0.2 * share, 0.01, 0.003 * share});
  }
  return shift;
}

/// Of all tiles, as they are saved but for the packing [bytes].
std::size_t BytesOf(SemanticMap& map) {
  std::size_t bytes = 0;
  static_cast<void>(map.TakeChanged());
  for (const TileKey& tile : map.Tiles()) {
    bytes += map.OctreeOf(tile).Serialize().size();
  }
  return bytes;
}

void MeasureUpdates(double duration_s, double shift_every_s) {
  const std::vector<TimedPing> pings = Survey(duration_s);
  SemanticMap map{Meters(kVoxel)};
  AnchoredGrid ground(kArea, Meters(0.25), CameraModel{}, map.beams(), MapParams{}.seam_loss);
  GroundLooks looks(LookModel{}, LookParams{});
  std::vector<ObservedFrame> frames;
  std::vector<double> updates_ms;
  double next_tick = kTick, next_shift = shift_every_s;
  int unsettled = 0, shifts = 0;
  for (const TimedPing& ping : pings) {
    const double start = ThreadTime().value();
    map.beams().Add(ping.t, ping.beams, ping.ends);
    ground.TakePings();
    if (ping.t >= next_shift) {
      map.beams().Shift(LoopClosed(ping.t));
      ground.Shift(LoopClosed(ping.t));
      looks.BeginAnew();
      next_shift += shift_every_s;
      ++shifts;
    }
    if (ping.t >= next_tick) {
      ground.Observe(
          {.t = ping.t, .X_WB = ping.beams.pose(), .altitude = kAltitude});  // a frame a tick
      frames.push_back(
          {.exposure = Seconds(ping.t), .X_WB = ping.beams.pose(), .altitude = kAltitude});
      const bool is_settled = map.beams().Settle();
      static_cast<void>(looks.Settle(frames, map));
      unsettled += ground.Settle() && is_settled ? 0 : 1;
      next_tick += kTick;
    }
    updates_ms.push_back(1e3 * (ThreadTime().value() - start));
  }
  const double start = ThreadTime().value();
  const std::size_t bytes = BytesOf(map);
  fmt::print(
      "| {:.1f} | {} | {} | {:.3f} | {:.2f} | {:.2f} | {:.0f} % | {:.0f} | {:.1f} | {:.1f} |\n",
      duration_s / 3600.0, pings.size(), shifts, Quantile(updates_ms, 0.5),
      Quantile(updates_ms, 0.99), Quantile(updates_ms, 1.0), 100.0 * unsettled * kTick / duration_s,
      1e3 * (ThreadTime().value() - start), 1e-6 * static_cast<double>(bytes),
      1e-6 * static_cast<double>(map.beams().held_bytes()));
}

}  // namespace

int main() {
  CompareInsertion();
  fmt::print(
      "\n| hours | pings | loops closed | update, median [ms] | 99 % [ms] | worst [ms] | time "
      "behind "
      "the track | save after all [ms] | saved [MB] | counts [MB] |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n");
  MeasureUpdates(1200.0, 120.0);
  MeasureUpdates(1200.0, 10.0);
  MeasureUpdates(6 * 3600.0, 600.0);
  return 0;
}
