// SPDX-License-Identifier: MIT
// sweep_speed: how many motions a second planners can value by what they would newly show, over
// 1 000 m^2 and over a square kilometre: each is swept and taken back, as searches do, by the beam
// (levels of cells, a byte each) and by tours (planes of cells, a bit each). Beside it, in the same
// run, the bytes of the ground under its images, and what share that is of the bytes that this core
// reads at most, from its cache and from memory. Times are of this thread's processor.
#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "limpet/core/clock.hpp"
#include "limpet/core/random.hpp"
#include "limpet/planning/seen_along.hpp"
#include "limpet/planning/seen_planes.hpp"

namespace {

using namespace limpet;

/// Bytes a second that are read of so many, over and over; the best of several tries.
double ReadingRate(std::size_t bytes) {
  std::vector<std::uint64_t> words(bytes / sizeof(std::uint64_t), 1);
  constexpr double kEnough = 4e9;  // [bytes] a try
  const int rounds = std::max(1, static_cast<int>(kEnough / static_cast<double>(bytes)));
  double best = 0.0;
  std::uint64_t sum = 0;
  for (int attempt = 0; attempt < 3; ++attempt) {
    const double begun = ThreadTime().value();
    for (int round = 0; round < rounds; ++round) {
      std::uint64_t four[4] = {};
      for (std::size_t i = 0; i + 4 <= words.size(); i += 4) {
        for (std::size_t k = 0; k < 4; ++k)
          four[k] += words[i + k];
      }
      sum += four[0] + four[1] + four[2] + four[3];
      words[static_cast<std::size_t>(round) % words.size()] ^= sum & 1U;  // no round is left out
    }
    const double took = ThreadTime().value() - begun;
    best = std::max(best, static_cast<double>(bytes) * rounds / took);
  }
  return best;
}

struct Rates {
  double motions = 0.0;  ///< a second
  double bytes = 0.0;    ///< of the ground under images, a second
};

constexpr double kLength = 4.0;  // of a motion [m]
constexpr int kMotions = 20000;

/// Cells under a motion's images, each layer by itself, those that images share once.
double CellsUnder(const Footprint& image, double cell_m, std::initializer_list<int> layers) {
  double cells = 0.0;
  for (const int layer : layers) {
    const double along = 2.0 * image.half_along(layer) + kLength;
    cells += 2.0 * image.half_across(layer) * along / (cell_m * cell_m);
  }
  return cells;
}

/// Motions straight or with the vehicle's turning radius, from anywhere in the area; `value` says
/// what one shows, `bytes` lie under it.
template <class Workspace, class Value>
Rates Sweep(Workspace& workspace, const SurveyArea& area, double bytes, Value value) {
  constexpr double kCurvature = 1.0 / 1.5;
  Random random(1, "sweeps");
  double shown = 0.0;
  const double begun = ThreadTime().value();
  for (int i = 0; i < kMotions; ++i) {
    const Pose2 from{.north = random.Uniform(0.0, area.north_max),
                     .east = random.Uniform(0.0, area.east_max),
                     .yaw = random.Uniform(-std::numbers::pi, std::numbers::pi)};
    const auto mark = workspace.Mark();
    shown += value(from, PathSegment{.curvature = kCurvature * static_cast<double>(i % 3 - 1),
                                     .length = kLength});
    workspace.Rewind(mark);
  }
  const double took = ThreadTime().value() - begun;
  if (shown <= 0.0) fmt::print("nothing was shown\n");
  return {.motions = kMotions / took, .bytes = kMotions * bytes / took};
}

/// An area of which nothing has been seen, as planners have it.
struct Site {
  SurveyArea area;
  SurveyGrid grid{area};
  Footprint image{{.altitude = 4.0, .object_height_max = area.object_height_max}, CameraModel{}};
  Ground ground{grid, image};
};

Rates SweepLevels(const Site& site) {
  SeenWorkspace workspace(site.ground);
  const double cells = CellsUnder(site.image, site.ground.frame().cell_m, {0, 1, 2, 3});
  return Sweep(workspace, site.area, cells, [&](const Pose2& from, const PathSegment& motion) {
    return workspace.Sweep(from, motion).new_area;
  });
}

Rates SweepPlanes(const Site& site) {
  constexpr double kCellsPerByte = 8.0;
  SeenPlanes planes(site.ground);
  const double cells = CellsUnder(site.image, site.ground.frame().cell_m, {0, 3});
  const auto left = [&] { return planes.unseen()[SeenPlanes::kTop]; };
  return Sweep(planes, site.area, cells / kCellsPerByte,
               [&](const Pose2& from, const PathSegment& motion) {
                 const int before = left();
                 planes.Look(from);
                 planes.Sweep(from, motion);
                 return before - left();
               });
}

SurveyArea Area(double north, double east) {
  SurveyArea area;
  area.north_min = 0.0, area.north_max = north;
  area.east_min = 0.0, area.east_max = east;
  area.margin = 2.0;
  area.object_height_max = 2.0;
  return area;
}

}  // namespace

int main() {
  constexpr std::size_t kCached = 16384, kMemory = 268435456;  // [bytes]
  const double cache = ReadingRate(kCached), memory = ReadingRate(kMemory);
  fmt::print("this core reads {:.1f} GB/s from its cache, {:.1f} GB/s from memory\n\n",
             1e-9 * cache, 1e-9 * memory);
  fmt::print("{:<22} {:>14} {:>14} {:>10} {:>10}\n", "area", "evaluations/s", "ground [GB/s]",
             "of cache", "of memory");
  const auto tell = [&](const std::string& name, const Rates& rates) {
    fmt::print("{:<22} {:>14.0f} {:>14.3f} {:>10.4f} {:>10.4f}\n", name, rates.motions,
               1e-9 * rates.bytes, rates.bytes / cache, rates.bytes / memory);
  };
  for (const double side : {33.0, 1000.0}) {
    const Site site{.area = Area(side, side)};
    tell(fmt::format("{0:.0f} x {0:.0f} m, levels", side), SweepLevels(site));
    tell(fmt::format("{0:.0f} x {0:.0f} m, planes", side), SweepPlanes(site));
  }
  return 0;
}
