// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limpet/core/camera_model.hpp"
#include "limpet/survey/grid_frame.hpp"
#include "limpet/survey/sight_obstacles.hpp"
#include "limpet/survey/simple_polygon.hpp"
#include "limpet/survey/tile_grid.hpp"
#include "limpet/survey/wanted_cells.hpp"
#include "limpet/topics/mapping.hpp"
#include "limpet/topics/mission.hpp"

namespace limpet {

/// What of the survey area has been seen: per cell the greatest height above the seabed up to which
/// an object would have been seen there. One number is enough because the image narrows upwards:
/// what is inside the image at one height was inside it at every lower one.
///
/// Rule. A cell's bottom is seen when its sample point is inside the image. An object floating at
/// height h counts as seen when at least 60 % of its disc is in the image, that is, when its centre
/// is at least `kDiscInset` inside every edge of the image at h (0.158 radii: the chord that leaves
/// 60 % of a disc). With a level camera at altitude a the height seen at body offset (x forward, y
/// starboard) is therefore
///     h = a - max((|y| + inset) / tan(across/2), (|x| + inset) / tan(along/2)),
/// clipped to [0, object_height_max]. Roll and pitch turn the four side planes; h stays the least
/// of four linear bounds. Three frames are not counted: at 4 fps and 0.5 m/s they are 0.25 m of
/// track, far less than the image is long.
///
/// Water. What is farther away than the reach (HalfRange of the detector) does not count as seen.
/// The closest that a cell's bottom has ever been is kept, so that what has been seen follows from
/// what is known of the water today: at closest range r and reach d, heights above r - d were in
/// sight. (Along the ray to the bottom this is exact; straight above the cell it is up to 0.1 m too
/// low inside an image of 60 x 45 degrees.)
///
/// Cells are kept in tiles that come into being when something of them has been seen: memory and
/// time go with the ground seen, not with the area.
class SurveyGrid {
 public:
  /// Inset of an object's centre from the image's edge [m], for discs of 0.5 m radius.
  static constexpr double kDiscInset = 0.08;
  /// Objects' centres float no lower than their radius [m]; the band of Coverage starts here.
  static constexpr double kObjectRadius = 0.5;

  /// A grid over `area` or the box around it (FrameOf). A cell that has been seen takes 16 bytes.
  /// REQUIRES: no ProblemOf(area, cell_m).
  explicit SurveyGrid(const SurveyArea& area, double cell_m = kGridCell_m);
  /// The mirror of a grid that is known by its deltas.
  SurveyGrid(const GridFrame& frame, double object_height_max);
  /// One of the same ground that has seen nothing.
  [[nodiscard]] SurveyGrid Blank() const;

  /// Marks what the camera sees from `X_WB`. `altitude` [m] is the height of the body origin above
  /// the seabed; it stands in where the seabed's depth is not known. The image is drawn in by
  /// `allowance` [m] on every side (SeamAllowance). What `shadows`, of this camera, hide is not
  /// seen. Returns how many cells it looked at.
  int Observe(const Pose& X_WB, double altitude, const CameraModel& camera, double allowance = 0.0,
              const Shadows& shadows = {});
  /// A point of the seabed (a DVL beam's end): moves the depth of the cells within
  /// `kSeabedReach` towards `down` [m]. Returns how many those are.
  int SetSeabed(const Eigen::Vector3d& point_W);
  static constexpr double kSeabedReach = 0.75;
  /// How far one sees [m]; before the first call without limit. Changes what has been seen.
  void SetReach(double reach);

  /// Takes another grid's state, which may have seen less. REQUIRES: a grid of the same area.
  void Become(SurveyGrid&& other);

  /// Cells seen higher or lower, or with a new seabed depth, since the last call; each once. What
  /// Apply took over is another grid's to tell.
  [[nodiscard]] GridDelta TakeDelta();
  /// All cells ever seen, as one delta.
  [[nodiscard]] GridDelta Everything() const;
  /// Takes over another grid's changes; false, with nothing changed, if its frame is another one.
  [[nodiscard]] bool Apply(const GridDelta& delta);

  /// Takes ground that obstacles stand on, by index and in order (StandingGround), from what is to
  /// be seen; ground given before and not now is to be seen again. False if nothing has changed.
  bool SetStanding(std::vector<std::uint32_t> cells);
  /// Shares of the ground that is wanted.
  [[nodiscard]] Coverage coverage() const;
  /// Whether the cell is to be seen: it is of the area, and nothing stands on it.
  [[nodiscard]] bool IsWanted(int row, int column) const {
    return !wanted_ || wanted_->Has(row, column);
  }
  /// Whether its sample point lies in the area and in no keep-out zone.
  [[nodiscard]] bool IsOfArea(int row, int column) const {
    return !of_area_ || of_area_->Has(row, column);
  }
  [[nodiscard]] PlanePoint SamplePoint(int row, int column) const {
    return limpet::SamplePoint(frame_, row, column);
  }
  [[nodiscard]] std::size_t wanted_cells() const;
  [[nodiscard]] const GridFrame& frame() const { return frame_; }
  [[nodiscard]] double object_height_max() const { return height_max_; }
  /// Greatest height seen [m], or nothing if not even the bottom has been inside the image.
  [[nodiscard]] std::optional<double> SeenHeight(int row, int column) const;
  /// Heights above the seabed below this were out of reach of every image of the cell [m]; 0 if its
  /// bottom was in sight. In steps of 0.1 m, upwards.
  [[nodiscard]] double SeenFloor(int row, int column) const;
  /// NED depth of the seabed [m], or nothing.
  [[nodiscard]] std::optional<double> Seabed(int row, int column) const;

  /// A cell as planners' inner loops read it.
  struct Look {
    float height = kNeverSeen;  ///< as SeenHeight
    float floor = 0.0F;         ///< as SeenFloor
  };
  static constexpr float kNeverSeen = -1.0F;
  [[nodiscard]] Look LookAt(int row, int column) const {
    const Cell& cell = cells_.At(row, column);
    return {.height = cell.seen, .floor = FloorOf(cell)};
  }
  /// Increases with every change; mirrors compare it to know whether they are stale.
  [[nodiscard]] std::uint64_t version() const { return version_; }

 private:
  enum class SeabedSource : std::uint8_t { kNone, kAltitude, kBeam };
  static constexpr float kFloorStep = 0.1F;  ///< [m]
  struct Cell {
    float seen = kNeverSeen;  ///< greatest height [m]
    float closest =
        std::numeric_limits<float>::infinity();  ///< range of its bottom [m]; not of a mirror
    float seabed = 0.0F;                         ///< NED depth [m]
    std::uint16_t floor = 0;                     ///< in steps
    SeabedSource seabed_source = SeabedSource::kNone;
    std::uint8_t beam_count : 7 = 0;
    std::uint8_t is_changed : 1 = 0;
  };
  /// What a tile's cells that are wanted add to the coverage, as last counted.
  struct Counted {
    double bottom = 0.0, band = 0.0, top = 0.0;
    bool is_due = true;  ///< cells have changed since
  };
  using Tiles = TileGrid<Cell, Counted>;
  /// A cell to be written to, and where it is.
  struct Place {
    Tiles::Tile& tile;
    Cell& cell;
    std::uint32_t index;  ///< as deltas have it
  };

  [[nodiscard]] static float FloorOf(const Cell& cell) {
    return kFloorStep * static_cast<float>(cell.floor);
  }
  [[nodiscard]] bool Holds(int row, int column) const;
  /// REQUIRES: Holds(row, column).
  [[nodiscard]] std::uint32_t Index(int row, int column) const;
  [[nodiscard]] Place PlaceOf(int row, int column);
  [[nodiscard]] Place PlaceOf(std::uint32_t index);
  void Raise(const Place& at, float height, float seabed_down);
  void SetHeight(const Place& at, float height);
  void Approach(const Place& at, float range);
  [[nodiscard]] static std::uint16_t FloorSteps(float floor);
  void SetFloor(const Place& at, float floor);
  void MarkStale(const Place& at);
  void MarkChanged(const Place& at);
  /// Cells changed by going through tiles are told row by row all the same.
  void SortChanges(std::size_t from);
  [[nodiscard]] static GridDelta::Cell ChangeOf(std::uint32_t index, const Cell& cell);
  void Count(Tiles::Tile& tile) const;

  GridFrame frame_;
  double height_max_;
  float reach_;
  /// Counting what has been seen notes down in each tile what came of it.
  mutable Tiles cells_;
  std::shared_ptr<const WantedCells> of_area_;  ///< null: all are
  std::vector<std::uint32_t> standing_;         ///< cells that something stands on
  std::shared_ptr<const WantedCells> wanted_;   ///< of the area without those; null: all are
  std::vector<std::uint32_t> changed_;
  std::uint64_t version_ = 0;
};

}  // namespace limpet
