// SPDX-License-Identifier: MIT
#include "limpet/map_files/depth_grid.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "estimation/mapping/map_export.hpp"
#include "estimation/mapping/saved_map.hpp"
#include "limpet/topics/grid_place.hpp"

namespace limpet {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

std::vector<Voxel> GroundVoxels(const SemanticOctree& octree) {
  std::vector<Voxel> voxels = OccupiedOf(octree).voxels;
  std::erase_if(voxels,
                [](const Voxel& voxel) { return voxel.belief.label != VoxelLabel::kGround; });
  return voxels;
}

/// A grid whose cells' middles go from `low` to `high`, nothing known in it.
DepthGrid EmptyGrid(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double cell_m) {
  DepthGrid grid;
  grid.frame = {.north_min = low.x() - 0.5 * cell_m,
                .east_min = low.y() - 0.5 * cell_m,
                .cell_m = cell_m,
                .rows = static_cast<int>(std::lround((high.x() - low.x()) / cell_m)) + 1,
                .columns = static_cast<int>(std::lround((high.y() - low.y()) / cell_m)) + 1};
  const auto cells =
      static_cast<std::size_t>(grid.frame.rows) * static_cast<std::size_t>(grid.frame.columns);
  grid.down_m.assign(cells, kUnknown);
  grid.sigma_m.assign(cells, kUnknown);
  return grid;
}

DepthGrid EmptyGridAround(const std::vector<Voxel>& voxels, double cell_m) {
  Eigen::Vector3d low = voxels.front().p_W, high = low;
  for (const Voxel& voxel : voxels) {
    low = low.cwiseMin(voxel.p_W);
    high = high.cwiseMax(voxel.p_W);
  }
  return EmptyGrid(low.head<2>(), high.head<2>(), cell_m);
}

std::size_t CellOf(const DepthGrid& grid, double north, double east) {
  const auto index = [&grid](double offset) {
    return static_cast<int>(std::floor(offset / grid.frame.cell_m));
  };
  return grid.Index(index(north - grid.frame.north_min), index(east - grid.frame.east_min));
}
std::size_t CellOf(const DepthGrid& grid, const Voxel& voxel) {
  return CellOf(grid, voxel.p_W.x(), voxel.p_W.y());
}

/// Extent of the columns' middles: south-west and north-east.
std::array<Eigen::Vector2d, 2> ExtentOf(const std::vector<DepthColumn>& columns) {
  Eigen::Vector2d low(columns.front().north, columns.front().east), high = low;
  for (const DepthColumn& column : columns) {
    low = low.cwiseMin(Eigen::Vector2d(column.north, column.east));
    high = high.cwiseMax(Eigen::Vector2d(column.north, column.east));
  }
  return {low, high};
}

/// Sums over the voxels of one column that touch the one where most beams ended.
struct Column {
  double most = 0.0, most_down = 0.0;
  double weight = 0.0, down = 0.0, square = 0.0;
};

/// Cells of a grid that nobody needs to hold: 25 km2 of columns of 0.2 m.
constexpr double kTooManyCells = 6e8;

}  // namespace

std::optional<std::size_t> DepthGrid::At(const Eigen::Vector2d& p_W) const {
  const std::optional<GridPlace> place = GridPlaceOf(frame, p_W);
  if (!place) return std::nullopt;
  const std::size_t cell = Index(place->row, place->column);
  return IsKnown(cell) ? std::optional(cell) : std::nullopt;
}

DepthGrid DepthGridOf(const DepthMap& depths) {
  const std::vector<DepthColumn> columns = depths.Columns();
  if (columns.empty()) return {};
  const auto [low, high] = ExtentOf(columns);
  DepthGrid grid = EmptyGrid(low, high, depths.cell_m());
  grid.zero_sigma_m = depths.zero_sigma();
  for (const DepthColumn& column : columns) {
    const std::size_t cell = CellOf(grid, column.north, column.east);
    grid.down_m[cell] = static_cast<float>(column.down);
    grid.sigma_m[cell] = static_cast<float>(column.sigma);
  }
  return grid;
}

Expected<DepthGrid> DepthGridOf(const SessionMemory& memory) {
  if (!memory.depths.empty()) {
    const Expected<DepthMap> depths = DepthMap::Parse(memory.depths);
    if (!depths) return Error{"depths.csv: " + depths.error().text};
    const std::vector<DepthColumn> columns = depths->Columns();
    if (columns.empty()) return DepthGrid{};
    const auto [low, high] = ExtentOf(columns);
    const Eigen::Vector2d cells = (high - low) / depths->cell_m();
    if ((cells.x() + 1.0) * (cells.y() + 1.0) > kTooManyCells) {
      return Error{"depths.csv: its columns lie too far apart"};
    }
    return DepthGridOf(*depths);
  }
  if (memory.map.empty()) return DepthGrid{};
  const Expected<SemanticOctree> octree = OctreeOf(memory.map);
  if (!octree) return octree.error();
  return DepthGridOf(*octree);
}

DepthGrid DepthGridOf(const SemanticOctree& octree) {
  const std::vector<Voxel> voxels = GroundVoxels(octree);
  if (voxels.empty()) return {};
  const double edge = octree.resolution();
  DepthGrid grid = EmptyGridAround(voxels, edge);
  std::vector<Column> columns(grid.down_m.size());
  for (const Voxel& voxel : voxels) {
    Column& column = columns[CellOf(grid, voxel)];
    const auto weight = static_cast<double>(voxel.belief.occupied);
    if (weight > column.most) {
      column.most = weight;
      column.most_down = voxel.p_W.z();
    }
  }
  for (const Voxel& voxel : voxels) {
    Column& column = columns[CellOf(grid, voxel)];
    const double off = voxel.p_W.z() - column.most_down;
    if (std::abs(off) > 1.5 * edge) continue;
    const auto weight = static_cast<double>(voxel.belief.occupied);
    column.weight += weight;
    column.down += weight * off;
    column.square += weight * off * off;
  }
  for (std::size_t cell = 0; cell < columns.size(); ++cell) {
    const Column& column = columns[cell];
    if (column.weight <= 0.0) continue;
    const double mean = column.down / column.weight;
    const double variance = std::max(0.0, column.square / column.weight - mean * mean);
    grid.down_m[cell] = static_cast<float>(column.most_down + mean);
    grid.sigma_m[cell] = static_cast<float>(std::sqrt(variance + edge * edge / 12.0));
  }
  return grid;
}

}  // namespace limpet
