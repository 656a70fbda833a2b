// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "limpet/core/camera_model.hpp"
#include "limpet/planning/pose2.hpp"
#include "limpet/survey/survey_grid.hpp"
#include "limpet/survey/view_cone.hpp"

namespace limpet {

/// Heights of a survey above the seabed [m].
struct SurveyHeights {
  double altitude = 0.0;           ///< of the camera
  double object_height_max = 0.0;  ///< top of the band that is looked through
};

/// What a level camera at survey altitude shows: half extents of the image at each layer of the
/// band, from the bottom up. Where the water hides a layer's corners, of it and of all above it as
/// much of the image counts as is in sight, so that layers nest. A layer of which too little is in
/// sight (ShareInSight) is out of reach: it has no extent, and does not cut those above it.
class Footprint {
 public:
  static constexpr int kLayers = 4;
  static constexpr int kTop = kLayers - 1;
  /// Heights of the layers above the seabed [m]: k/3 of the band; all 0 if the band is. `reach`:
  /// how far one sees [m].
  Footprint(const SurveyHeights& heights, const CameraModel& camera,
            double reach = std::numeric_limits<double>::infinity());

  /// Images count as this much smaller on every side [m].
  void DrawIn(double by);
  [[nodiscard]] double half_across(int layer) const { return across_[Slot(layer)]; }
  [[nodiscard]] double half_along(int layer) const { return along_[Slot(layer)]; }
  /// Width of the image, mean over the layers [m]; never quite 0, so that it can be divided by.
  [[nodiscard]] double swath() const;
  /// The lowest layer in reach, which holds all above it; the bottom if none is.
  [[nodiscard]] int widest_layer() const;
  /// False if the layer is too far below the camera for this water.
  [[nodiscard]] bool is_in_reach(int layer) const { return in_reach_[Slot(layer)]; }
  /// Height above the seabed of a layer [m].
  [[nodiscard]] double height(int layer) const { return height_[Slot(layer)]; }

 private:
  static std::size_t Slot(int layer) { return static_cast<std::size_t>(layer); }
  std::array<double, kLayers> across_{}, along_{}, height_{};
  std::array<bool, kLayers> in_reach_{};
};

/// How much each layer of the band counts, from the bottom up; they sum to one. More weight at the
/// bottom covers the seabed sooner and the band's top later.
using LayerWeights = std::array<double, Footprint::kLayers>;
/// Best in the study (tests/bench/planner_study): 12 % less way to 95 % of the seabed than uniform
/// layers at the same way to 95 % of the band.
inline constexpr LayerWeights kBottomTwice = {0.4, 0.2, 0.2, 0.2};

/// The planner's copy of a survey grid: per cell the number of layers seen, 0 to
/// Footprint::kLayers, from the bottom up; layers out of reach count as done, as nothing can be
/// done about them, and so do cells that are not to be seen. Because layers nest, area and border
/// of all layers are sums over these numbers alone. Of a grid that is too large to be planned at
/// once it copies a window, and is a ground of that size; where images are wide, by squares of
/// cells, which count as seen as the least of their cells: plans for wide images need no finer
/// ones.
class Ground {
 public:
  Ground(const SurveyGrid& grid, const Footprint& footprint,
         const LayerWeights& weights = kBottomTwice);
  /// REQUIRES: a window of cells of the grid, not empty; cells_per_side > 0.
  Ground(const SurveyGrid& grid, const Footprint& footprint, const LayerWeights& weights,
         const CellBox& window, int cells_per_side = 1);
  /// Takes the grid's present state; cheap if it has not changed since.
  void Update(const SurveyGrid& grid);

  /// Frame of the window; its cells are the squares that plans are made on.
  [[nodiscard]] const GridFrame& frame() const { return frame_; }
  /// Whether it is only a part of its grid.
  [[nodiscard]] bool is_part() const { return is_part_; }
  [[nodiscard]] const Footprint& footprint() const { return footprint_; }
  [[nodiscard]] const LayerWeights& weights() const { return weights_; }
  /// Width of the image, weighted mean over the layers [m]: new area over this is useful track.
  [[nodiscard]] double swath() const;
  [[nodiscard]] std::span<const std::uint8_t> levels() const { return levels_; }
  /// Share of (cell, layer) seen.
  [[nodiscard]] double SeenShare() const;
  /// Changes with every update that found something new.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  /// Share of cells seen up to `layer`.
  [[nodiscard]] double SeenShare(int layer) const;
  /// Cells that are to be seen; 1 if there is none.
  [[nodiscard]] std::size_t wanted_cells() const { return wanted_cells_; }
  /// Cells of the area, whatever stands there.
  [[nodiscard]] std::size_t cells_of_area() const { return cells_of_area_; }
  [[nodiscard]] double wanted_m2() const {
    return static_cast<double>(wanted_cells_) * frame_.cell_m * frame_.cell_m;
  }

 private:
  [[nodiscard]] std::uint8_t LevelOf(const SurveyGrid& grid, int row, int column) const;
  /// Least level of the cells in the square whose first cell this is.
  [[nodiscard]] std::uint8_t LeastLevelOf(const SurveyGrid& grid, int row, int column) const;
  /// Whether `is` holds for any of the cells in the square whose first cell this is.
  template <class Is>
  [[nodiscard]] bool HasOne(int row, int column, Is is) const;
  [[nodiscard]] std::size_t CellsOfArea(const SurveyGrid& grid) const;

  GridFrame frame_;
  CellBox window_;
  int cells_per_side_;
  bool is_part_;
  Footprint footprint_;
  LayerWeights weights_;
  std::size_t cells_of_area_ = 0, wanted_cells_ = 1;
  std::vector<std::uint8_t> levels_;
  std::uint64_t version_ = ~std::uint64_t{0};
};

}  // namespace limpet
