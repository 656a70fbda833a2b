// SPDX-License-Identifier: MIT
#include "limpet/survey/grid_frame.hpp"

#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "limpet/core/require.hpp"
#include "limpet/survey/survey_shape.hpp"

namespace limpet {
namespace {

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
  if (!(rows * columns <= kMostGridCells)) {
    return fmt::format("is too large: {}; at most {:g} cells of {:g} m, such as {:g} x {:g} m",
                       given, kMostGridCells, cell_m, std::sqrt(kMostGridCells) * cell_m,
                       std::sqrt(kMostGridCells) * cell_m);
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

PlanePoint SamplePoint(const GridFrame& frame, int row, int column) {
  const auto cell = static_cast<std::uint32_t>(row * frame.columns + column);
  const auto cell_m = static_cast<float>(frame.cell_m);
  return {
      frame.north_min + row * frame.cell_m + static_cast<double>(cell_m * HashToUnit(cell, 0)),
      frame.east_min + column * frame.cell_m + static_cast<double>(cell_m * HashToUnit(cell, 1))};
}

}  // namespace limpet
