// SPDX-License-Identifier: MIT
#include <string>
#include <utility>

#include <fmt/format.h>

#include "limpet/figures/figures.hpp"
#include "limpet/figures/map_axes.hpp"
#include "limpet/figures/map_symbols.hpp"
#include "limpet/figures/probability_text.hpp"
#include "limpet/objects/status_posterior.hpp"
#include "limpet/scoring/verdict.hpp"

namespace limpet {
namespace {

using Point = SvgCanvas::Point;

void DrawChange(MapAxes& map, const ChangeScore& change, bool is_judged) {
  if (!change.p_W) return;
  const Point at = map.At(change.p_W->head<2>());
  DrawStatus(map.canvas(), at, change.decided, 8.0);
  const std::string decided =
      fmt::format("{} {}", NameOf(change.decided), ProbabilityText(change.probability));
  PlaceLabel label{.lines = {decided}};
  if (is_judged) label.lines = {change.truth.value_or("nothing is here"), decided};
  if (is_judged && !change.is_right() && !change.is_open()) {
    map.canvas().Circle(at, 14.0, {.stroke = palette::kVermillion, .width = 2.5});
    label.lines.push_back(fmt::format(
        "wrong: {}", change.expected ? NameOf(*change.expected) : "there was never anything"));
    label.distance = 20.0;
  }
  DrawLabel(map, *change.p_W, label);
}

void DrawChangeLegend(MapAxes& map, bool is_judged) {
  map.LegendHeading("Decided");
  constexpr std::pair<Status, const char*> kMeanings[] = {
      {Status::kConfirmed, "confirmed: there both times"},
      {Status::kRemoved, "removed: there before only"},
      {Status::kNew, "new: there now only"},
      {Status::kMoved, "moved: there, elsewhere"},
      {Status::kUncertain, "uncertain: looks say too little"},
      {Status::kNotInspected, "not inspected: no look"}};
  for (const auto& [status, meaning] : kMeanings) {
    map.Legend([drawn = status](SvgCanvas& canvas,
                                const Point& at) { DrawStatus(canvas, at, drawn, 6.5); },
               meaning);
  }
  if (!is_judged) return;
  map.LegendHeading("Truth");
  map.Legend(
      [](SvgCanvas& canvas, const Point& at) {
        canvas.Circle(at, 8.0, {.stroke = palette::kMapInk, .width = 1.4});
      },
      "object there now");
  map.Legend(
      [](SvgCanvas& canvas, const Point& at) {
        canvas.Circle(at, 8.0, {.stroke = palette::kMapMuted, .width = 1.4, .dash = "3 3"});
      },
      "object there before only");
  map.Legend(
      [](SvgCanvas& canvas, const Point& at) {
        canvas.Circle(at, 9.0, {.stroke = palette::kVermillion, .width = 2.5});
      },
      "decision is wrong");
}

void DrawTruthOfBoth(MapAxes& map, const FigureSource& source) {
  for (const ScenarioOpi& opi : source.scenario.opis) {
    const auto now = opi.Place(source.score.name);
    const auto before = opi.Place(source.score.former);
    if (now) DrawTruth(map, *now, opi.radius_m);
    if (before && !now) {
      map.canvas().Circle(map.At(before->head<2>()), opi.radius_m * map.pixels_per_metre(),
                          {.stroke = palette::kMapMuted, .width = 1.4, .dash = "3 3"});
    }
  }
}

std::string TitleOfChanges(const SessionScore& score) {
  const std::size_t count = score.opis.changes.size();
  if (!score.has_truth) {
    return fmt::format("What changed: {} decisions, not judged: no truth", count);
  }
  return fmt::format("What changed: {} of {} statuses right", StatusesRight(score), count);
}

}  // namespace

Figure ChangeFigure(const FigureSource& source) {
  const SessionRecord& record = source.record;
  const OpiScores& opis = source.score.opis;
  const SurveyArea area = AreaOf(record);
  MapAxes map(area, TitleOfChanges(source.score),
              RunName(source) + " \u00b7 against " + source.score.former +
                  ", with the probability of what was decided");
  map.BeginMap();
  map.Raster(record.grid, [](const SeenCell&) { return palette::Rgb{246, 249, 250}; });
  map.Outline(area);
  if (source.score.has_truth) DrawTruthOfBoth(map, source);
  for (const ChangeScore& change : opis.changes)
    DrawChange(map, change, source.score.has_truth);
  map.EndMap();
  DrawChangeLegend(map, source.score.has_truth);
  return {record.name + "_status.svg",
          "Shape and colour both tell the status. Rings are the truth, at true size: drawn through "
          "for what is there now, dashed for what was there before. White ground was seen in this "
          "session.",
          map.Finish()};
}

}  // namespace limpet
