// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limpet/figures/figures.hpp"
#include "limpet/figures/map_axes.hpp"
#include "limpet/mission/seabed.hpp"

namespace limpet {
namespace {

struct DepthRange {
  double shallow = 0.0, deep = 1.0;
  [[nodiscard]] double ShareOf(double down) const {
    return std::clamp((down - shallow) / (deep - shallow), 0.0, 1.0);
  }
};

/// The middle 99 % of the depths, widened to half a metre at least: a flat bottom must look flat.
DepthRange RangeOf(const GridRecord& grid) {
  std::vector<double> depths;
  grid.EachSeen([&depths](int, int, const SeenCell& cell) {
    depths.push_back(static_cast<double>(cell.seabed_down));
  });
  if (depths.empty()) return {};
  std::sort(depths.begin(), depths.end());
  const std::size_t tail = depths.size() / 200;
  DepthRange range{depths[tail], depths[depths.size() - 1 - tail]};
  const double missing = 0.5 - (range.deep - range.shallow);
  if (missing > 0.0) range.shallow -= 0.5 * missing, range.deep += 0.5 * missing;
  return range;
}

/// Mapped less true depth over the cells seen [m].
struct DepthError {
  double mean = 0.0, spread = 0.0;
};

DepthError ErrorOf(const GridRecord& grid, const Seabed& seabed) {
  double sum = 0.0, squares = 0.0, count = 0.0;
  grid.EachSeen([&](int row, int column, const SeenCell& cell) {
    const double truth = seabed.Depth({grid.frame.north_min + (row + 0.5) * grid.frame.cell_m,
                                       grid.frame.east_min + (column + 0.5) * grid.frame.cell_m});
    const double error = static_cast<double>(cell.seabed_down) - truth;
    sum += error, squares += error * error, count += 1.0;
  });
  if (count == 0.0) return {};
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(squares / count - mean * mean, 0.0))};
}

std::string TitleOfDepths(const FigureSource& source) {
  if (!source.score.has_truth) return "Depth of the bottom as mapped";
  const DepthError error = ErrorOf(source.record.grid, Seabed(source.scenario.seabed));
  return fmt::format("Depth of the bottom as mapped: {:.2f} m too {} on average, \u00b1 {:.2f} m",
                     std::abs(error.mean), error.mean < 0.0 ? "shallow" : "deep", error.spread);
}

}  // namespace

Figure DepthFigure(const FigureSource& source) {
  const GridRecord& grid = source.record.grid;
  const SurveyArea area = AreaOf(source.record);
  const DepthRange range = RangeOf(grid);
  MapAxes map(area, TitleOfDepths(source),
              RunName(source) + " \u00b7 from the DVL\u2019s four beams");
  map.BeginMap();
  map.Raster(grid, [&](const SeenCell& cell) {
    const double share = range.ShareOf(static_cast<double>(cell.seabed_down));
    return palette::Viridis(std::round((1.0 - share) * 200.0) / 200.0);  // shallow is bright
  });
  map.Outline(area);
  map.EndMap();
  map.ColorBar([](double share) { return palette::Viridis(share); },
               fmt::format("{:.2f} m deep", range.deep),
               fmt::format("{:.2f} m deep", range.shallow), "Depth below the surface");
  return {
      source.record.name + "_depth.svg",
      "Every cell carries the depth that the DVL's beams near by gave. The scale spans the middle "
      "99 % of the depths, and half a metre at least. Where the true bottom is known, the title "
      "compares with it.",
      map.Finish()};
}

}  // namespace limpet
