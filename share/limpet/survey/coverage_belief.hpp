// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "limpet/core/camera_model.hpp"
#include "limpet/objects/frame.hpp"
#include "limpet/survey/survey_grid.hpp"
#include "limpet/survey/tile_grid.hpp"
#include "limpet/survey/view_cone.hpp"

namespace limpet {

/// An image of which it is known how surely the vehicle knew its place.
struct PlacedView {
  double t = 0.0;  ///< [s]
  Pose X_WB{};
  double altitude = 0.0;  ///< of the body origin above the seabed [m]
  PlaceSigma sigma{};     ///< zero: exact
};

/// How much of the survey area has been seen, in expectation: the vehicle does not know to the
/// centimetre where its images lie.
///
/// Passes. A place that lies `d` inside an image's edge was seen by it with probability
/// Phi(d / s), with s the 1-sigma of the image's place against the pass beside it over sqrt(2): of
/// what two passes may have come apart each bears its half. Images of one pass err alike, so the
/// best of a pass speaks for it; passes err on their own, so their evidence adds up:
/// P(unseen) is the product over the passes.
///
/// Edges. What is off alike in all images of a place (a fix, the first heading) opens no gap, but
/// the area's edges then lie elsewhere in the map: the expectation is over the map's place, with
/// what was seen beyond the edges, too.
class CoverageBelief {
 public:
  /// What was seen so far beyond the area is kept, for edges that lie elsewhere [m].
  static constexpr double kSkirt = 2.5;

  /// REQUIRES: `grid` is one of `area`.
  CoverageBelief(const SurveyArea& area, const SurveyGrid& grid);

  /// Takes an image in; `grid`, of the same area, knows the seabed. Images come in order of time.
  /// What `shadows`, of this camera, hide is not seen. Returns how many cells it looked at.
  /// Allocates only where nothing had been seen before.
  int Observe(const PlacedView& view, const CameraModel& camera, const SurveyGrid& grid,
              const Shadows& shadows = {});
  /// What was out of reach in the water, or what obstacles stand on, has changed in `grid`.
  void CountAnew();
  /// Expected shares of the ground that is wanted. `grid` knows what was out of reach in the water.
  /// Its time goes with what has been seen since the last call.
  [[nodiscard]] Coverage Expected(const SurveyGrid& grid) const;

 private:
  static constexpr std::size_t kLevels = 4;  ///< bottom; lowest, middle and greatest height
  using Shares = std::array<double, kLevels>;
  /// Evidence that a cell was seen up to each level, in steps of 1/12 bit of what is left unseen.
  struct Cell {
    std::array<std::uint8_t, kLevels> passes{}, pass{};  ///< former ones; the latest
    float last = -1.0F;          ///< when that one last saw it, since the first image [s]
    std::uint8_t map_sigma = 0;  ///< absolute, of the latest image [steps of 5 cm]
    bool is_of_area = false;     ///< this and the next one are known once the tile is prepared
    std::uint8_t to_rim = 0;     ///< the next cell on an edge's other side is so far off [cells]
  };
  /// What a tile's cells add to the expectation, as last counted.
  struct Counted {
    Shares sum{};
    bool is_prepared = false;
    bool is_due = true;  ///< it has been seen since
  };
  using Tiles = TileGrid<Cell, Counted>;

  [[nodiscard]] PlanePoint SamplePoint(int row, int column, const SurveyGrid& grid) const;
  /// What all cells of an image have in common.
  struct Image {
    ViewCone cone;
    double sigma = 0.0;          ///< of its place beside the vehicle's way, this image's share [m]
    double since = 0.0;          ///< taken so long after the first [s]
    std::uint8_t map_sigma = 0;  ///< as Cell has it
  };
  void Add(const Image& image, const Eigen::Vector3d& sample_W, const std::array<int, 2>& at);
  [[nodiscard]] std::optional<double> Seabed(int row, int column, const SurveyGrid& grid) const;
  /// Chance that the cell was seen at each level, in sight in this water.
  [[nodiscard]] Shares SeenAt(int row, int column, const Cell& cell, const SurveyGrid& grid) const;
  [[nodiscard]] bool IsInside(int row, int column) const;
  [[nodiscard]] bool IsOfArea(int row, int column, const SurveyGrid& grid) const;
  /// An obstacle was found in the same map: wherever that lies, its ground is not to be seen.
  [[nodiscard]] bool IsStoodOn(int row, int column, const SurveyGrid& grid) const;
  /// How much more of the cell counts because the map may lie elsewhere; below 0: less.
  [[nodiscard]] double EdgeChange(int row, int column, const Cell& cell,
                                  const SurveyGrid& grid) const;
  void Prepare(Tiles::Tile& tile, const SurveyGrid& grid) const;
  void Count(Tiles::Tile& tile, const SurveyGrid& grid) const;

  int skirt_;        ///< [cells]
  GridFrame frame_;  ///< with the skirt
  std::array<double, kLevels> heights_{};
  /// What is expected is noted down in each tile when it is counted.
  mutable Tiles cells_;
  std::optional<double> first_t_;  ///< of the images [s]
};

}  // namespace limpet
