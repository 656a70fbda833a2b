// SPDX-License-Identifier: MIT
#include "limpet/survey/survey_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/require.hpp"
#include "limpet/survey/survey_shape.hpp"
#include "limpet/survey/view_cone.hpp"

namespace limpet {
namespace {

constexpr int kMostBeamWeight = 8;
constexpr float kUnlimited = std::numeric_limits<float>::infinity();

GridFrame FrameOf(const SurveyArea& area, double cell_m) {
  LIMPET_REQUIRE(cell_m > 0.0, "cells need a size");
  LIMPET_REQUIRE(area.north_max > area.north_min && area.east_max > area.east_min,
                 "the survey area is empty");
  // A rounding error must not add a row.
  const auto cells = [cell_m](double extent) {
    return static_cast<int>(std::ceil(extent / cell_m - 1e-6));
  };
  return {.north_min = area.north_min,
          .east_min = area.east_min,
          .cell_m = cell_m,
          .rows = cells(area.north_max - area.north_min),
          .columns = cells(area.east_max - area.east_min)};
}

/// Uniform in [0, 1), a function of the cell and the axis alone.
float HashToUnit(std::uint32_t cell, std::uint32_t axis) {
  std::uint32_t x = cell * 2U + axis + 0x9e3779b9U;
  x = (x ^ (x >> 16U)) * 0x85ebca6bU;
  x = (x ^ (x >> 13U)) * 0xc2b2ae35U;
  x ^= x >> 16U;
  return static_cast<float>(x >> 8U) * 0x1p-24F;
}

}  // namespace

std::optional<std::string> ProblemOf(const SurveyArea& area, double cell_m) {
  constexpr double kWidestMargin = 1000.0, kHighestObject = 100.0;  // [m]
  const std::string given =
      fmt::format("north {:g} to {:g}, east {:g} to {:g} m, margin {:g} m, objects up to {:g} m",
                  area.north_min, area.north_max, area.east_min, area.east_max, area.margin,
                  area.object_height_max);
  const double rows = std::ceil((area.north_max - area.north_min) / cell_m);
  const double columns = std::ceil((area.east_max - area.east_min) / cell_m);
  // Written so that what is no number is refused, too.
  if (!(rows > 0.0 && columns > 0.0)) {
    return "has no extent: " + given;
  }
  if (!(rows * columns <= SurveyGrid::kMostCells)) {
    return fmt::format("is too large: {}; at most {:g} cells of {:g} m, such as {:g} x {:g} m",
                       given, SurveyGrid::kMostCells, cell_m,
                       std::sqrt(SurveyGrid::kMostCells) * cell_m,
                       std::sqrt(SurveyGrid::kMostCells) * cell_m);
  }
  const bool is_sane = area.margin >= 0.0 && area.margin <= kWidestMargin &&
                       area.object_height_max >= 0.0 && area.object_height_max <= kHighestObject;
  if (!is_sane) {
    return fmt::format("makes no sense: {}; allowed: margin 0 to {:g}, objects 0 to {:g}", given,
                       kWidestMargin, kHighestObject);
  }
  const Expected<SurveyShape> shape = SurveyShape::Of(area);
  return shape ? std::nullopt : std::optional(shape.error().text);
}

SurveyGrid::SurveyGrid(const SurveyArea& area, double cell_m)
    : SurveyGrid(FrameOf(area, cell_m), area.object_height_max) {
  const Expected<SurveyShape> shape = SurveyShape::Of(area);
  LIMPET_REQUIRE(shape.has_value(), "the survey area is no area");
  if (shape->is_plain()) return;
  is_wanted_.resize(seen_.size());
  wanted_cells_ = 0;
  for (std::size_t cell = 0; cell < seen_.size(); ++cell) {
    is_wanted_[cell] = shape->Wants(SamplePoint(cell)) ? 1 : 0;
    wanted_cells_ += is_wanted_[cell];
  }
}

SurveyGrid::SurveyGrid(const GridFrame& frame, double object_height_max)
    : frame_(frame), height_max_(std::max(0.0, object_height_max)), reach_(kUnlimited) {
  LIMPET_REQUIRE(frame.rows > 0 && frame.columns > 0 && frame.cell_m > 0.0, "empty grid frame");
  const std::size_t count =
      static_cast<std::size_t>(frame.rows) * static_cast<std::size_t>(frame.columns);
  seen_.assign(count, kNeverSeen);
  floor_.assign(count, 0);
  closest_.assign(count, kUnlimited);
  seabed_.assign(count, 0.0F);
  seabed_source_.assign(count, SeabedSource::kNone);
  beam_count_.assign(count, 0);
  is_changed_.assign(count, 0);
  changed_.reserve(count);
  jitter_north_.resize(count);
  jitter_east_.resize(count);
  const auto cell_m = static_cast<float>(frame.cell_m);
  for (std::size_t i = 0; i < count; ++i) {
    jitter_north_[i] = cell_m * HashToUnit(static_cast<std::uint32_t>(i), 0);
    jitter_east_[i] = cell_m * HashToUnit(static_cast<std::uint32_t>(i), 1);
  }
  wanted_cells_ = count;
}

PlanePoint SurveyGrid::SamplePoint(std::size_t cell) const {
  const auto columns = static_cast<std::size_t>(frame_.columns);
  return {frame_.north_min + static_cast<double>(cell / columns) * frame_.cell_m +
              static_cast<double>(jitter_north_[cell]),
          frame_.east_min + static_cast<double>(cell % columns) * frame_.cell_m +
              static_cast<double>(jitter_east_[cell])};
}

std::size_t SurveyGrid::Index(int row, int column) const {
  LIMPET_REQUIRE(row >= 0 && row < frame_.rows && column >= 0 && column < frame_.columns,
                 "cell outside the survey grid");
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(frame_.columns) +
         static_cast<std::size_t>(column);
}

int SurveyGrid::Observe(const Pose& X_WB, double altitude, const CameraModel& camera,
                        double allowance) {
  if (!(altitude > 0.0)) {
    return 0;
  }
  ViewCone cone(X_WB, camera, kDiscInset);
  cone.DrawIn(allowance);
  const double guessed_down = X_WB.p_WB.z() + altitude;
  const CellBox box = cone.CellsBelow(frame_, guessed_down);
  for (int row = box.row_min; row <= box.row_max; ++row) {
    const double north_edge = frame_.north_min + row * frame_.cell_m;
    for (int column = box.column_min; column <= box.column_max; ++column) {
      const std::size_t cell = Index(row, column);
      const double down =
          seabed_source_[cell] == SeabedSource::kNone ? guessed_down : seabed_[cell];
      const double east = frame_.east_min + column * frame_.cell_m + jitter_east_[cell];
      const Eigen::Vector3d sample{north_edge + jitter_north_[cell], east, down};
      if (const auto height = cone.SeenHeight(sample)) {
        Approach(cell, static_cast<float>((sample - X_WB.p_WB).norm()));
        Raise(cell, static_cast<float>(std::min(*height, height_max_)),
              static_cast<float>(guessed_down));
      }
    }
  }
  return std::max(0, box.row_max - box.row_min + 1) *
         std::max(0, box.column_max - box.column_min + 1);
}

void SurveyGrid::Raise(std::size_t cell, float height, float seabed_down) {
  if (seabed_source_[cell] == SeabedSource::kNone) {
    seabed_[cell] = seabed_down;
    seabed_source_[cell] = SeabedSource::kAltitude;
  }
  if (height > seen_[cell]) {
    SetHeight(cell, height);
  }
}

void SurveyGrid::SetHeight(std::size_t cell, float height) {
  if (height != seen_[cell]) {
    seen_[cell] = height;
    MarkChanged(cell);
  }
}

void SurveyGrid::Approach(std::size_t cell, float range) {
  if (range < closest_[cell]) {
    closest_[cell] = range;
    SetFloor(cell, range - reach_);
  }
}

void SurveyGrid::SetFloor(std::size_t cell, float floor) {
  constexpr float kMostSteps = 65535.0F, kRounding = 1e-3F;
  const float steps = std::ceil(floor / kFloorStep - kRounding);
  // Written so that what is no number is 0.
  const auto floor_steps =
      static_cast<std::uint16_t>(steps > 0.0F ? std::min(steps, kMostSteps) : 0.0F);
  if (floor_steps != floor_[cell]) {
    floor_[cell] = floor_steps;
    MarkChanged(cell);
  }
}

void SurveyGrid::SetReach(double reach) {
  reach_ = static_cast<float>(reach);
  for (std::size_t cell = 0; cell < seen_.size(); ++cell) {
    if (seen_[cell] >= 0.0F) {
      SetFloor(cell, closest_[cell] - reach_);
    }
  }
}

void SurveyGrid::MarkChanged(std::size_t cell) {
  ++version_;
  if (is_changed_[cell] == 0) {
    is_changed_[cell] = 1;
    changed_.push_back(static_cast<std::uint32_t>(cell));
  }
}

int SurveyGrid::SetSeabed(double north, double east, double down) {
  const auto first = [this](double offset) {
    return static_cast<int>(std::ceil((offset - kSeabedReach) / frame_.cell_m - 0.5));
  };
  const auto last = [this](double offset) {
    return static_cast<int>(std::floor((offset + kSeabedReach) / frame_.cell_m - 0.5));
  };
  const double dn = north - frame_.north_min, de = east - frame_.east_min;
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
      const std::size_t cell = Index(row, column);
      const bool had_beam = seabed_source_[cell] == SeabedSource::kBeam;
      const int weight = had_beam ? std::min<int>(beam_count_[cell], kMostBeamWeight) : 0;
      const double before = had_beam ? static_cast<double>(seabed_[cell]) : down;
      seabed_[cell] = static_cast<float>(before + (down - before) / (weight + 1));
      seabed_source_[cell] = SeabedSource::kBeam;
      beam_count_[cell] = static_cast<std::uint8_t>(weight + 1);
      if (seen_[cell] >= 0.0F) {
        MarkChanged(cell);
      }
    }
  }
  return cells;
}

void SurveyGrid::Become(SurveyGrid&& other) {
  LIMPET_REQUIRE(other.seen_.size() == seen_.size(), "another area's grid");
  for (std::size_t cell = 0; cell < seen_.size(); ++cell) {
    const bool has_moved = other.seen_[cell] >= 0.0F && other.seabed_[cell] != seabed_[cell];
    if (has_moved || other.seen_[cell] != seen_[cell] || other.floor_[cell] != floor_[cell]) {
      MarkChanged(cell);
    }
  }
  seen_ = std::move(other.seen_);
  floor_ = std::move(other.floor_);
  closest_ = std::move(other.closest_);
  seabed_ = std::move(other.seabed_);
  seabed_source_ = std::move(other.seabed_source_);
  beam_count_ = std::move(other.beam_count_);
}

GridDelta SurveyGrid::TakeDelta() {
  GridDelta delta;
  delta.frame = frame_;
  delta.cells.reserve(changed_.size());
  for (const std::uint32_t cell : changed_) {
    delta.cells.push_back({.index = cell,
                           .seen_height = seen_[cell],
                           .seabed_down = seabed_[cell],
                           .seen_floor = Floor(cell)});
    is_changed_[cell] = 0;
  }
  changed_.clear();
  return delta;
}

GridDelta SurveyGrid::Everything() const {
  GridDelta delta;
  delta.frame = frame_;
  for (std::size_t cell = 0; cell < seen_.size(); ++cell) {
    if (seen_[cell] >= 0.0F) {
      delta.cells.push_back({.index = static_cast<std::uint32_t>(cell),
                             .seen_height = seen_[cell],
                             .seabed_down = seabed_[cell],
                             .seen_floor = Floor(cell)});
    }
  }
  return delta;
}

bool SurveyGrid::Apply(const GridDelta& delta) {
  const GridFrame& other = delta.frame;
  if (other.rows != frame_.rows || other.columns != frame_.columns ||
      other.cell_m != frame_.cell_m || other.north_min != frame_.north_min ||
      other.east_min != frame_.east_min) {
    return false;
  }
  for (const GridDelta::Cell& change : delta.cells) {
    if (change.index >= seen_.size()) {
      return false;
    }
  }
  for (const GridDelta::Cell& change : delta.cells) {
    seabed_[change.index] = change.seabed_down;
    seabed_source_[change.index] = SeabedSource::kBeam;
    beam_count_[change.index] = kMostBeamWeight;
    SetHeight(change.index, change.seen_height >= 0.0F ? change.seen_height : kNeverSeen);
    SetFloor(change.index, change.seen_floor);
  }
  return true;
}

Coverage SurveyGrid::coverage() const {
  constexpr double kTopTolerance = 1e-3;
  const double low = std::min(kObjectRadius, height_max_);
  double bottom = 0.0, band = 0.0, top = 0.0;
  for (std::size_t cell = 0; cell < seen_.size(); ++cell) {
    if (!IsWanted(cell)) continue;
    const auto h = static_cast<double>(seen_[cell]), floor = static_cast<double>(Floor(cell));
    bottom += h >= 0.0 && floor <= 0.0 ? 1.0 : 0.0;
    const bool is_top_seen = h >= height_max_ - kTopTolerance && floor <= height_max_;
    top += is_top_seen ? 1.0 : 0.0;
    if (height_max_ > low) {
      band += std::clamp((h - std::max(low, floor)) / (height_max_ - low), 0.0, 1.0);
    } else {
      band += is_top_seen ? 1.0 : 0.0;
    }
  }
  const double count = std::max(1.0, static_cast<double>(wanted_cells_));
  return {.seabed = bottom / count, .band = band / count, .band_top = top / count};
}

std::optional<double> SurveyGrid::SeenHeight(int row, int column) const {
  const float height = seen_[Index(row, column)];
  return height >= 0.0F ? std::optional<double>(height) : std::nullopt;
}

std::optional<double> SurveyGrid::Seabed(int row, int column) const {
  return SeabedAt(Index(row, column));
}

}  // namespace limpet
