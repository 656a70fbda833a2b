// SPDX-License-Identifier: MIT
#include "limpet/survey/survey_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "limpet/core/require.hpp"
#include "limpet/survey/survey_shape.hpp"
#include "limpet/survey/view_cone.hpp"

namespace limpet {
namespace {

constexpr int kMostBeamWeight = 8;
constexpr float kUnlimited = std::numeric_limits<float>::infinity();

}  // namespace

SurveyGrid::SurveyGrid(const SurveyArea& area, double cell_m)
    : SurveyGrid(FrameOf(area, cell_m), area.object_height_max) {
  const Expected<SurveyShape> shape = SurveyShape::Of(area);
  LIMPET_REQUIRE(shape.has_value(), "the survey area is no area");
  if (shape->is_plain()) return;
  of_area_ = std::make_shared<const WantedCells>(
      *shape, frame_, [this](int row, int column) { return SamplePoint(row, column); });
  wanted_ = of_area_;
}

SurveyGrid::SurveyGrid(const GridFrame& frame, double object_height_max)
    : frame_(frame),
      height_max_(std::max(0.0, object_height_max)),
      reach_(kUnlimited),
      cells_(frame.rows, frame.columns) {
  LIMPET_REQUIRE(frame.cell_m > 0.0, "cells need a size");
}

SurveyGrid SurveyGrid::Blank() const {
  SurveyGrid blank(frame_, height_max_);
  blank.of_area_ = of_area_;
  blank.standing_ = standing_;
  blank.wanted_ = wanted_;
  return blank;
}

std::size_t SurveyGrid::wanted_cells() const {
  return wanted_ ? wanted_->count()
                 : static_cast<std::size_t>(frame_.rows) * static_cast<std::size_t>(frame_.columns);
}

bool SurveyGrid::Holds(int row, int column) const {
  return row >= 0 && row < frame_.rows && column >= 0 && column < frame_.columns;
}

std::uint32_t SurveyGrid::Index(int row, int column) const {
  LIMPET_REQUIRE(Holds(row, column), "cell outside the survey grid");
  return static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(frame_.columns) +
         static_cast<std::uint32_t>(column);
}

SurveyGrid::Place SurveyGrid::PlaceOf(int row, int column) {
  const std::uint32_t index = Index(row, column);
  Tiles::Tile& tile = cells_.TileAt(row, column);
  return {.tile = tile, .cell = Tiles::CellOf(tile, row, column), .index = index};
}

SurveyGrid::Place SurveyGrid::PlaceOf(std::uint32_t index) {
  const auto columns = static_cast<std::uint32_t>(frame_.columns);
  return PlaceOf(static_cast<int>(index / columns), static_cast<int>(index % columns));
}

int SurveyGrid::Observe(const Pose& X_WB, double altitude, const CameraModel& camera,
                        double allowance, const Shadows& shadows) {
  if (!(altitude > 0.0)) {
    return 0;
  }
  ViewCone cone(X_WB, camera, kDiscInset);
  cone.DrawIn(allowance);
  const double guessed_down = X_WB.p_WB.z() + altitude;
  const auto highest = static_cast<float>(height_max_);
  const CellBox box = cone.CellsBelow(frame_, guessed_down);
  for (int row = box.row_min; row <= box.row_max; ++row) {
    for (int column = box.column_min; column <= box.column_max; ++column) {
      const Cell& known = cells_.At(row, column);
      const bool has_seabed = known.seabed_source != SeabedSource::kNone;
      const PlanePoint place = SamplePoint(row, column);
      const Eigen::Vector3d sample{place.x(), place.y(),
                                   has_seabed ? static_cast<double>(known.seabed) : guessed_down};
      const auto range = static_cast<float>((sample - X_WB.p_WB).norm());
      // Most cells of an image have been seen as high, and from nearer, by the one before.
      if (has_seabed && known.seen >= highest && range >= known.closest) continue;
      if (const auto height = cone.SeenHeight(sample); height && !shadows.Hide(sample)) {
        const Place at = PlaceOf(row, column);
        Approach(at, range);
        Raise(at, static_cast<float>(std::min(*height, height_max_)),
              static_cast<float>(guessed_down));
      }
    }
  }
  return std::max(0, box.row_max - box.row_min + 1) *
         std::max(0, box.column_max - box.column_min + 1);
}

void SurveyGrid::Raise(const Place& at, float height, float seabed_down) {
  if (at.cell.seabed_source == SeabedSource::kNone) {
    at.cell.seabed = seabed_down;
    at.cell.seabed_source = SeabedSource::kAltitude;
  }
  if (height > at.cell.seen) {
    SetHeight(at, height);
  }
}

void SurveyGrid::SetHeight(const Place& at, float height) {
  if (height != at.cell.seen) {
    at.cell.seen = height;
    MarkChanged(at);
  }
}

void SurveyGrid::Approach(const Place& at, float range) {
  if (range < at.cell.closest) {
    at.cell.closest = range;
    SetFloor(at, range - reach_);
  }
}

std::uint16_t SurveyGrid::FloorSteps(float floor) {
  constexpr float kMostSteps = 65535.0F, kRounding = 1e-3F;
  const float steps = std::ceil(floor / kFloorStep - kRounding);
  // Written so that what is no number is 0.
  return static_cast<std::uint16_t>(steps > 0.0F ? std::min(steps, kMostSteps) : 0.0F);
}

void SurveyGrid::SetFloor(const Place& at, float floor) {
  const std::uint16_t steps = FloorSteps(floor);
  if (steps != at.cell.floor) {
    at.cell.floor = steps;
    MarkChanged(at);
  }
}

void SurveyGrid::SetReach(double reach) {
  reach_ = static_cast<float>(reach);
  const std::size_t before = changed_.size();
  cells_.EachTile([this](Tiles::Tile& tile) {
    cells_.EachCell(tile, [&](int row, int column, Cell& cell) {
      if (cell.seen < 0.0F) return;
      SetFloor({.tile = tile, .cell = cell, .index = Index(row, column)}, cell.closest - reach_);
    });
  });
  SortChanges(before);
}

void SurveyGrid::MarkStale(const Place& at) {
  ++version_;
  at.tile.note.is_due = true;
}

void SurveyGrid::MarkChanged(const Place& at) {
  MarkStale(at);
  if (at.cell.is_changed == 0) {
    at.cell.is_changed = 1;
    changed_.push_back(at.index);
  }
}

int SurveyGrid::SetSeabed(const Eigen::Vector3d& point_W) {
  const auto first = [this](double offset) {
    return static_cast<int>(std::ceil((offset - kSeabedReach) / frame_.cell_m - 0.5));
  };
  const auto last = [this](double offset) {
    return static_cast<int>(std::floor((offset + kSeabedReach) / frame_.cell_m - 0.5));
  };
  const double dn = point_W.x() - frame_.north_min, de = point_W.y() - frame_.east_min;
  int cells = 0;
  for (int row = std::max(0, first(dn)); row <= std::min(frame_.rows - 1, last(dn)); ++row) {
    for (int column = std::max(0, first(de)); column <= std::min(frame_.columns - 1, last(de));
         ++column) {
      const double off_north = (row + 0.5) * frame_.cell_m - dn;
      const double off_east = (column + 0.5) * frame_.cell_m - de;
      if (std::hypot(off_north, off_east) > kSeabedReach) {
        continue;
      }
      ++cells;
      const Place at = PlaceOf(row, column);
      Cell& cell = at.cell;
      const bool had_beam = cell.seabed_source == SeabedSource::kBeam;
      const int weight = had_beam ? std::min<int>(cell.beam_count, kMostBeamWeight) : 0;
      const double before = had_beam ? static_cast<double>(cell.seabed) : point_W.z();
      cell.seabed = static_cast<float>(before + (point_W.z() - before) / (weight + 1));
      cell.seabed_source = SeabedSource::kBeam;
      cell.beam_count = static_cast<std::uint8_t>(weight + 1) & 0x7FU;
      if (cell.seen >= 0.0F) {
        MarkChanged(at);
      }
    }
  }
  return cells;
}

void SurveyGrid::Become(SurveyGrid&& other) {
  LIMPET_REQUIRE(other.frame_.rows == frame_.rows && other.frame_.columns == frame_.columns,
                 "another area's grid");
  const std::size_t before = changed_.size();
  other.cells_.EachTile(
      [this](const Tiles::Tile& tile) { static_cast<void>(cells_.TileAt(tile.row, tile.column)); });
  cells_.EachTile([&](Tiles::Tile& tile) {
    tile.note.is_due = true;
    cells_.EachCell(tile, [&](int row, int column, Cell& cell) {
      Cell next = other.cells_.At(row, column);
      const bool has_moved = next.seen >= 0.0F && next.seabed != cell.seabed;
      if (has_moved || next.seen != cell.seen || next.floor != cell.floor) {
        MarkChanged({.tile = tile, .cell = cell, .index = Index(row, column)});
      }
      next.is_changed = cell.is_changed;
      cell = next;
    });
  });
  SortChanges(before);
}

bool SurveyGrid::SetStanding(std::vector<std::uint32_t> cells) {
  if (cells == standing_) return false;
  const auto at = [this](std::uint32_t index) {
    const auto columns = static_cast<std::uint32_t>(frame_.columns);
    return std::pair{static_cast<int>(index / columns), static_cast<int>(index % columns)};
  };
  auto wanted =
      of_area_ ? std::make_shared<WantedCells>(*of_area_) : std::make_shared<WantedCells>(frame_);
  for (const std::uint32_t index : cells) {
    const auto [row, column] = at(index);
    LIMPET_REQUIRE(Holds(row, column), "cell outside the survey grid");
    wanted->Drop(row, column);
  }
  for (const auto& changed : {standing_, cells}) {
    for (const std::uint32_t index : changed) {
      const auto [row, column] = at(index);
      if (Tiles::Tile* tile = cells_.FindTile(row, column)) tile->note.is_due = true;
    }
  }
  standing_ = std::move(cells);
  wanted_ = standing_.empty() ? of_area_ : std::move(wanted);
  ++version_;
  return true;
}

void SurveyGrid::SortChanges(std::size_t from) {
  std::sort(changed_.begin() + static_cast<std::ptrdiff_t>(from), changed_.end());
}

GridDelta::Cell SurveyGrid::ChangeOf(std::uint32_t index, const Cell& cell) {
  return {
      .index = index,
      .now = {.seen_height = cell.seen, .seabed_down = cell.seabed, .seen_floor = FloorOf(cell)}};
}

GridDelta SurveyGrid::TakeDelta() {
  GridDelta delta;
  delta.frame = frame_;
  delta.cells.reserve(changed_.size());
  // What a loop closure changes is not kept room for until the next one.
  for (const std::uint32_t index : std::exchange(changed_, {})) {
    Cell& cell = PlaceOf(index).cell;
    delta.cells.push_back(ChangeOf(index, cell));
    cell.is_changed = 0;
  }
  return delta;
}

GridDelta SurveyGrid::Everything() const {
  GridDelta delta;
  delta.frame = frame_;
  cells_.EachCell([&](int row, int column, const Cell& cell) {
    if (cell.seen >= 0.0F) delta.cells.push_back(ChangeOf(Index(row, column), cell));
  });
  std::ranges::sort(delta.cells, {}, &GridDelta::Cell::index);
  return delta;
}

bool SurveyGrid::Apply(const GridDelta& delta) {
  const GridFrame& other = delta.frame;
  if (other.rows != frame_.rows || other.columns != frame_.columns ||
      other.cell_m != frame_.cell_m || other.north_min != frame_.north_min ||
      other.east_min != frame_.east_min) {
    return false;
  }
  const std::size_t cells =
      static_cast<std::size_t>(frame_.rows) * static_cast<std::size_t>(frame_.columns);
  for (const GridDelta::Cell& change : delta.cells) {
    if (change.index >= cells) {
      return false;
    }
  }
  for (const GridDelta::Cell& change : delta.cells) {
    const Place at = PlaceOf(change.index);
    at.cell.seabed = change.now.seabed_down;
    at.cell.seabed_source = SeabedSource::kBeam;
    at.cell.beam_count = kMostBeamWeight;
    at.cell.seen = change.now.seen_height >= 0.0F ? change.now.seen_height : kNeverSeen;
    at.cell.floor = FloorSteps(change.now.seen_floor);
    MarkStale(at);
  }
  return true;
}

void SurveyGrid::Count(Tiles::Tile& tile) const {
  constexpr double kTopTolerance = 1e-3;
  const double low = std::min(kObjectRadius, height_max_);
  Counted counted{.is_due = false};
  cells_.EachCell(tile, [&](int row, int column, const Cell& cell) {
    if (!IsWanted(row, column)) return;
    const auto h = static_cast<double>(cell.seen), floor = static_cast<double>(FloorOf(cell));
    counted.bottom += h >= 0.0 && floor <= 0.0 ? 1.0 : 0.0;
    const bool is_top_seen = h >= height_max_ - kTopTolerance && floor <= height_max_;
    counted.top += is_top_seen ? 1.0 : 0.0;
    if (height_max_ > low) {
      counted.band += std::clamp((h - std::max(low, floor)) / (height_max_ - low), 0.0, 1.0);
    } else {
      counted.band += is_top_seen ? 1.0 : 0.0;
    }
  });
  tile.note = counted;
}

Coverage SurveyGrid::coverage() const {
  Counted sum;
  cells_.EachTile([&](Tiles::Tile& tile) {
    if (tile.note.is_due) Count(tile);
    sum.bottom += tile.note.bottom;
    sum.band += tile.note.band;
    sum.top += tile.note.top;
  });
  const double count = std::max(1.0, static_cast<double>(wanted_cells()));
  return {.seabed = sum.bottom / count, .band = sum.band / count, .band_top = sum.top / count};
}

std::optional<double> SurveyGrid::SeenHeight(int row, int column) const {
  LIMPET_REQUIRE(Holds(row, column), "cell outside the survey grid");
  const float height = cells_.At(row, column).seen;
  return height >= 0.0F ? std::optional<double>(height) : std::nullopt;
}

double SurveyGrid::SeenFloor(int row, int column) const {
  LIMPET_REQUIRE(Holds(row, column), "cell outside the survey grid");
  return static_cast<double>(FloorOf(cells_.At(row, column)));
}

std::optional<double> SurveyGrid::Seabed(int row, int column) const {
  LIMPET_REQUIRE(Holds(row, column), "cell outside the survey grid");
  const Cell& cell = cells_.At(row, column);
  return cell.seabed_source == SeabedSource::kNone ? std::nullopt
                                                   : std::optional<double>(cell.seabed);
}

}  // namespace limpet
