// SPDX-License-Identifier: MIT
#include "tests/bench/planner_study/track_svg.hpp"

#include <fstream>

#include <fmt/format.h>

namespace limpet {
namespace {

constexpr double kScale = 16.0;  // pixels per metre
constexpr int kFramesPerStroke = 8;

/// Cells not seen up to the top of the band: dark if not even at the bottom.
template <class X, class Y>
void DrawUnseen(std::ofstream& svg, const StudyCase& study, const StudyResult& result, X x, Y y) {
  const GridFrame& frame = result.frame;
  for (int row = 0; row < frame.rows; ++row) {
    for (int column = 0; column < frame.columns; ++column) {
      const auto height = static_cast<double>(
          result.heights[static_cast<std::size_t>(row * frame.columns + column)]);
      if (height < study.area.object_height_max - 1e-3) {
        svg << fmt::format(
            "<rect x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}' fill='{}'/>\n",
            x(frame.east_min + column * frame.cell_m),
            y(frame.north_min + (row + 1) * frame.cell_m), frame.cell_m * kScale,
            frame.cell_m * kScale, height < 0.0 ? "#888" : "#ddd");
      }
    }
  }
}

}  // namespace

void WriteTrackSvg(const std::string& file, const StudyCase& study, const StudyResult& result) {
  const SurveyArea& area = study.area;
  const double margin = area.margin + 1.0;
  const auto x = [&](double east) { return (east - area.east_min + margin) * kScale; };
  const auto y = [&](double north) { return (area.north_max + margin - north) * kScale; };
  const double width = x(area.east_max + margin), height = y(area.north_min - margin);
  std::ofstream svg(file);
  svg << fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' width='{0:.0f}' height='{1:.0f}'>"
      "<rect width='{0:.0f}' height='{1:.0f}' fill='white'/>\n",
      width, height);
  for (const double grow : {0.0, area.margin}) {
    svg << fmt::format(
        "<rect x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}' fill='none' stroke='black'/>\n",
        x(area.east_min - grow), y(area.north_max + grow),
        (area.east_max - area.east_min + 2.0 * grow) * kScale,
        (area.north_max - area.north_min + 2.0 * grow) * kScale);
  }
  DrawUnseen(svg, study, result, x, y);
  const auto count = static_cast<double>(result.track.size());
  for (std::size_t i = 0; i + kFramesPerStroke < result.track.size(); i += kFramesPerStroke) {
    const Pose2& a = result.track[i];
    const Pose2& b = result.track[i + kFramesPerStroke];
    svg << fmt::format(
        "<line x1='{:.1f}' y1='{:.1f}' x2='{:.1f}' y2='{:.1f}' stroke-width='3' "
        "stroke='hsl({:.0f},90%,{:.0f}%)'/>\n",
        x(a.east), y(a.north), x(b.east), y(b.north),
        270.0 - 210.0 * static_cast<double>(i) / count,
        25.0 + 25.0 * static_cast<double>(i) / count);
  }
  for (const Target& target : FormerObjects(0.0)) {
    svg << fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='6' fill='red'/>\n", x(target.east),
                       y(target.north));
  }
  svg << "</svg>\n";
}

}  // namespace limpet
