// SPDX-License-Identifier: MIT
#include "limpet/planning/unseen_patches.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {
namespace {

struct Cell {
  double north, east;
};

/// Box of the cells along the principal axis of their scatter.
Patch PatchOf(const std::vector<Cell>& cells, double cell_m) {
  const auto count = static_cast<double>(cells.size());
  double n = 0.0, e = 0.0;
  for (const Cell& cell : cells) {
    n += cell.north / count;
    e += cell.east / count;
  }
  double nn = 0.0, ee = 0.0, ne = 0.0;
  for (const Cell& cell : cells) {
    nn += (cell.north - n) * (cell.north - n);
    ee += (cell.east - e) * (cell.east - e);
    ne += (cell.north - n) * (cell.east - e);
  }
  Patch patch;
  patch.axis_yaw = 0.5 * std::atan2(2.0 * ne, nn - ee);
  const double c = std::cos(patch.axis_yaw), s = std::sin(patch.axis_yaw);
  double along_min = 0.0, along_max = 0.0, across_min = 0.0, across_max = 0.0;
  for (const Cell& cell : cells) {
    const double along = (cell.north - n) * c + (cell.east - e) * s;
    const double across = -(cell.north - n) * s + (cell.east - e) * c;
    along_min = std::min(along_min, along), along_max = std::max(along_max, along);
    across_min = std::min(across_min, across), across_max = std::max(across_max, across);
  }
  const double along = 0.5 * (along_min + along_max), across = 0.5 * (across_min + across_max);
  patch.north = n + along * c - across * s;
  patch.east = e + along * s + across * c;
  patch.length = along_max - along_min + cell_m;
  patch.width = across_max - across_min + cell_m;
  return patch;
}

}  // namespace

std::vector<Patch> UnseenPatches(const Ground& ground, double tile_m) {
  const GridFrame& frame = ground.frame();
  const int tile = std::max(1, static_cast<int>(std::lround(tile_m / frame.cell_m)));
  std::array<double, Footprint::kLayers + 1> missing{};
  for (std::size_t layer = Footprint::kLayers; layer-- > 0;) {
    missing[layer] = missing[layer + 1] + ground.weights()[layer];
  }
  std::vector<Patch> patches;
  std::vector<Cell> cells;
  for (int row0 = 0; row0 < frame.rows; row0 += tile) {
    for (int column0 = 0; column0 < frame.columns; column0 += tile) {
      cells.clear();
      double weight = 0.0;
      for (int row = row0; row < std::min(row0 + tile, frame.rows); ++row) {
        for (int column = column0; column < std::min(column0 + tile, frame.columns); ++column) {
          const std::uint8_t level = ground.levels()[static_cast<std::size_t>(row) *
                                                         static_cast<std::size_t>(frame.columns) +
                                                     static_cast<std::size_t>(column)];
          if (level < Footprint::kLayers) {
            weight += missing[level];
            cells.push_back({frame.north_min + (row + 0.5) * frame.cell_m,
                             frame.east_min + (column + 0.5) * frame.cell_m});
          }
        }
      }
      if (!cells.empty()) {
        patches.push_back(PatchOf(cells, frame.cell_m));
        patches.back().unseen_m2 = static_cast<double>(cells.size()) * frame.cell_m * frame.cell_m;
        patches.back().missing_m2 = weight * frame.cell_m * frame.cell_m;
      }
    }
  }
  std::stable_sort(patches.begin(), patches.end(),
                   [](const Patch& a, const Patch& b) { return a.missing_m2 > b.missing_m2; });
  return patches;
}

}  // namespace limpet
