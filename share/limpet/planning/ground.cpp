// SPDX-License-Identifier: MIT
#include "limpet/planning/ground.hpp"

#include <algorithm>
#include <cmath>

#include "limpet/core/require.hpp"
#include "limpet/survey/sight_reach.hpp"

namespace limpet {
namespace {

constexpr double kLeastSwath = 1e-3;  // [m]

CellBox Whole(const GridFrame& frame) {
  return {
      .row_min = 0, .row_max = frame.rows - 1, .column_min = 0, .column_max = frame.columns - 1};
}

GridFrame FrameOf(GridFrame frame, const CellBox& window, int cells_per_side) {
  const CellBox whole = Whole(frame);
  LIMPET_REQUIRE(window.row_min >= 0 && window.row_min <= window.row_max &&
                     window.row_max <= whole.row_max && window.column_min >= 0 &&
                     window.column_min <= window.column_max &&
                     window.column_max <= whole.column_max,
                 "a window of the grid");
  frame.north_min += window.row_min * frame.cell_m;
  frame.east_min += window.column_min * frame.cell_m;
  const auto squares = [cells_per_side](int cells) {
    return (cells + cells_per_side - 1) / cells_per_side;
  };
  frame.rows = squares(window.row_max - window.row_min + 1);
  frame.columns = squares(window.column_max - window.column_min + 1);
  frame.cell_m *= cells_per_side;
  return frame;
}

}  // namespace

Footprint::Footprint(const SurveyHeights& heights, const CameraModel& camera, double reach) {
  const double across = camera.half_across();
  const double along = camera.half_along();
  double scale = 1.0;
  for (int layer = 0; layer < kLayers; ++layer) {
    const std::size_t k = Slot(layer);
    height_[k] = std::max(0.0, heights.object_height_max) * layer / (kLayers - 1);
    const double inset =
        layer == 0 || heights.object_height_max <= 0.0 ? 0.0 : SurveyGrid::kDiscInset;
    const double distance = std::max(0.0, heights.altitude - height_[k]);
    across_[k] = std::max(0.0, distance * across - inset);
    along_[k] = std::max(0.0, distance * along - inset);
    const double share = ShareInSight({distance, std::hypot(across_[k], along_[k])}, reach);
    in_reach_[k] = share > 0.0;
    scale = in_reach_[k] ? std::min(scale, share) : scale;
    across_[k] *= in_reach_[k] ? scale : 0.0;
    along_[k] *= in_reach_[k] ? scale : 0.0;
  }
}

void Footprint::DrawIn(double by) {
  for (std::size_t k = 0; k < kLayers; ++k) {
    across_[k] = std::max(0.0, across_[k] - by);
    along_[k] = std::max(0.0, along_[k] - by);
  }
}

double Footprint::swath() const {
  double sum = 0.0;
  for (const double half : across_) {
    sum += 2.0 * half;
  }
  return std::max(kLeastSwath, sum / kLayers);
}

int Footprint::widest_layer() const {
  const auto found = std::find(in_reach_.begin(), in_reach_.end(), true);
  return found == in_reach_.end() ? 0 : static_cast<int>(found - in_reach_.begin());
}

Ground::Ground(const SurveyGrid& grid, const Footprint& footprint, const LayerWeights& weights)
    : Ground(grid, footprint, weights, Whole(grid.frame())) {}

Ground::Ground(const SurveyGrid& grid, const Footprint& footprint, const LayerWeights& weights,
               const CellBox& window, int cells_per_side)
    : frame_(FrameOf(grid.frame(), window, cells_per_side)),
      window_(window),
      cells_per_side_(cells_per_side),
      is_part_(frame_.rows != grid.frame().rows || frame_.columns != grid.frame().columns),
      footprint_(footprint),
      weights_(weights) {
  levels_.resize(static_cast<std::size_t>(frame_.rows) * static_cast<std::size_t>(frame_.columns));
  cells_of_area_ = CellsOfArea(grid);
  Update(grid);
}

std::uint8_t Ground::LevelOf(const SurveyGrid& grid, int row, int column) const {
  constexpr float kTolerance = 1e-3F;
  if (!grid.IsWanted(row, column)) return Footprint::kLayers;
  const SurveyGrid::Look look = grid.LookAt(row, column);
  int level = 0;
  while (level < Footprint::kLayers) {
    const auto height = static_cast<float>(footprint_.height(level));
    const bool is_seen =
        look.height >= std::max(0.0F, height - kTolerance) && look.floor <= height + kTolerance;
    if (!is_seen && footprint_.is_in_reach(level)) break;
    ++level;
  }
  return static_cast<std::uint8_t>(level);
}

std::uint8_t Ground::LeastLevelOf(const SurveyGrid& grid, int row, int column) const {
  std::uint8_t least = Footprint::kLayers;
  for (int r = row; r < row + cells_per_side_ && r <= window_.row_max; ++r) {
    for (int c = column; c < column + cells_per_side_ && c <= window_.column_max; ++c) {
      least = std::min(least, LevelOf(grid, r, c));
    }
  }
  return least;
}

template <class Is>
bool Ground::HasOne(int row, int column, Is is) const {
  for (int r = row; r < row + cells_per_side_ && r <= window_.row_max; ++r) {
    for (int c = column; c < column + cells_per_side_ && c <= window_.column_max; ++c) {
      if (is(r, c)) return true;
    }
  }
  return false;
}

std::size_t Ground::CellsOfArea(const SurveyGrid& grid) const {
  std::size_t cells = 0;
  for (int row = window_.row_min; row <= window_.row_max; row += cells_per_side_) {
    for (int column = window_.column_min; column <= window_.column_max; column += cells_per_side_) {
      cells += HasOne(row, column, [&grid](int r, int c) { return grid.IsOfArea(r, c); }) ? 1 : 0;
    }
  }
  return cells;
}

void Ground::Update(const SurveyGrid& grid) {
  LIMPET_REQUIRE(window_.row_max < grid.frame().rows && window_.column_max < grid.frame().columns,
                 "a ground mirrors one grid");
  if (version_ == grid.version()) {
    return;
  }
  version_ = grid.version();
  const auto is_wanted = [&grid](int row, int column) { return grid.IsWanted(row, column); };
  std::size_t cell = 0, wanted = 0;
  for (int row = window_.row_min; row <= window_.row_max; row += cells_per_side_) {
    for (int column = window_.column_min; column <= window_.column_max; column += cells_per_side_) {
      levels_[cell++] = LeastLevelOf(grid, row, column);
      wanted += HasOne(row, column, is_wanted) ? 1 : 0;
    }
  }
  wanted_cells_ = std::max<std::size_t>(1, wanted);
}

double Ground::swath() const {
  double sum = 0.0;
  for (int layer = 0; layer < Footprint::kLayers; ++layer) {
    sum += 2.0 * footprint_.half_across(layer) * weights_[static_cast<std::size_t>(layer)];
  }
  return std::max(kLeastSwath, sum);
}

double Ground::SeenShare() const {
  double sum = 0.0;
  for (const std::uint8_t level : levels_) {
    sum += level;
  }
  const auto unwanted = static_cast<double>(levels_.size() - wanted_cells_);
  return (sum - Footprint::kLayers * unwanted) /
         (Footprint::kLayers * static_cast<double>(wanted_cells_));
}

double Ground::SeenShare(int layer) const {
  const auto seen = std::count_if(levels_.begin(), levels_.end(),
                                  [layer](std::uint8_t level) { return level > layer; });
  const auto unwanted = static_cast<double>(levels_.size() - wanted_cells_);
  return (static_cast<double>(seen) - unwanted) / static_cast<double>(wanted_cells_);
}

}  // namespace limpet
