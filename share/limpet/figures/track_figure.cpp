// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "limpet/decision/deciding_bid.hpp"
#include "limpet/figures/figures.hpp"
#include "limpet/figures/map_axes.hpp"
#include "limpet/figures/map_symbols.hpp"

namespace limpet {
namespace {

using Point = SvgCanvas::Point;

constexpr Paint kTruePath{.stroke = palette::kMapInk, .width = 1.7};
constexpr Paint kPathHalo{.stroke = palette::kHalo, .width = 4.2, .opacity = 0.8};
constexpr Paint kEstimatedPath{.stroke = palette::kBlue, .width = 1.4, .dash = "5 3"};
constexpr Paint kOption{.stroke = palette::kMapMuted, .width = 0.6, .opacity = 0.2};

std::vector<Point> PointsOf(const MapAxes& map, const PoseTrack& track) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < track.size(); ++i) {
    points.push_back(map.At({track.north(i), track.east(i)}));
  }
  return Simplified(points, 0.3);
}

/// What each decision was for, by the bid that decided: the same generator offers paths for looks
/// and for ground. Decisions without bids on record are left out.
std::map<std::size_t, BidPurpose> PurposesOf(const std::vector<DecisionRecord>& decisions) {
  std::map<std::size_t, BidPurpose> purposes;
  for (std::size_t i = 0; i < decisions.size(); ++i) {
    const DecisionRecord& decision = decisions[i];
    if (decision.has_way && decision.offer && decision.offer->purpose) {
      purposes[i] = *decision.offer->purpose;
    }
  }
  return purposes;
}

std::string_view PurposeColor(BidPurpose purpose) {
  switch (purpose) {
    case BidPurpose::kLook:
      return palette::kVermillion;
    case BidPurpose::kHome:
      return palette::kPurple;
    case BidPurpose::kOther:
      return palette::kOrange;
    case BidPurpose::kCover:
      break;
  }
  return palette::kHalo;
}

void DrawDecisions(MapAxes& map, const std::vector<DecisionRecord>& decisions) {
  for (const DecisionRecord& decision : decisions) {
    const Point start = map.At({decision.north, decision.east});
    if (!decision.offer) continue;
    for (const auto& [north, east] : decision.offer->ends) {
      const Point end = map.At({north, east});
      map.canvas().Line(start, end, kOption);
      map.canvas().Circle(end, 1.4, {.fill = palette::kMapMuted, .opacity = 0.4});
    }
  }
}

/// A decision's radius on a map of this scale: those of a path, some 8 m apart, may not hide it.
double DecisionRadius(const MapAxes& map) {
  constexpr double kMetres = 1.8, kLeast_px = 1.3, kMost_px = 3.6;
  return std::clamp(kMetres * map.pixels_per_metre(), kLeast_px, kMost_px);
}

void DrawDecision(SvgCanvas& canvas, const Point& at, double radius, BidPurpose purpose) {
  canvas.Circle(
      at, radius,
      {.fill = PurposeColor(purpose), .stroke = palette::kMapInk, .width = 0.36 * radius});
}

void DrawDecisionPoints(MapAxes& map, const std::vector<DecisionRecord>& decisions) {
  const double radius = DecisionRadius(map);
  for (const auto& [i, purpose] : PurposesOf(decisions)) {
    DrawDecision(map.canvas(), map.At({decisions[i].north, decisions[i].east}), radius, purpose);
  }
}

void DrawDecisionLegend(MapAxes& map, const std::vector<DecisionRecord>& decisions) {
  const auto purposes = PurposesOf(decisions);
  map.LegendHeading("Decisions, by deciding bid");
  for (const auto& [purpose, text] : {std::pair{BidPurpose::kCover, "to cover"},
                                      std::pair{BidPurpose::kLook, "to look at an object"},
                                      std::pair{BidPurpose::kHome, "to go home"},
                                      std::pair{BidPurpose::kOther, "of another behavior"}}) {
    const auto count = std::ranges::count_if(
        purposes, [wanted = purpose](const auto& entry) { return entry.second == wanted; });
    if (purpose == BidPurpose::kOther && count == 0) continue;
    map.Legend([shown = purpose, radius = DecisionRadius(map)](
                   SvgCanvas& canvas, const Point& at) { DrawDecision(canvas, at, radius, shown); },
               fmt::format("{}: {}", text, count));
  }
}

/// An arrowhead about every 15 m of way, or 60 px, so that the track can be read in its order.
void DrawDirection(MapAxes& map, const PoseTrack& truth) {
  const double apart = std::max(15.0, 60.0 / map.pixels_per_metre());
  double next = 0.5 * apart;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    if (truth.path(i) < next) continue;
    const Point step =
        map.At({truth.north(i), truth.east(i)}) - map.At({truth.north(i - 1), truth.east(i - 1)});
    if (step.norm() < 1e-6) continue;  // on the spot, e.g. while diving
    next = truth.path(i) + apart;
    DrawTriangle(map.canvas(), map.At({truth.north(i), truth.east(i)}), 5.5,
                 Radians(std::atan2(step.x(), -step.y())), {.fill = palette::kMapInk});
  }
}

palette::Rgb HeightColor(double height, double top) {
  constexpr double kLevels = 8.0;
  const double share = top > 0.0 ? std::clamp(height / top, 0.0, 1.0) : 1.0;
  return palette::Coverage(std::round(share * kLevels) / kLevels);
}

void DrawTrackLegend(MapAxes& map, const FigureSource& source, double top) {
  const auto line = [](const Paint& paint) {
    return [paint](SvgCanvas& canvas, const Point& at) {
      canvas.Line(at - Point(12.0, 0.0), at + Point(12.0, 0.0), paint);
    };
  };
  map.LegendHeading("Vehicle");
  if (source.score.has_truth) map.Legend(line(kTruePath), "true track");
  map.Legend(line(kEstimatedPath), "track as estimated\nat the time");
  map.Legend(DrawHome, "start and home");
  DrawDecisionLegend(map, source.record.decisions);
  map.Legend(line(kOption), "the three best options,\nto their ends");
  if (source.score.has_truth) {
    map.LegendHeading("Objects");
    map.Legend(
        [](SvgCanvas& canvas, const Point& at) {
          canvas.Circle(at, 7.0, {.stroke = palette::kMapInk, .width = 1.4});
        },
        "true place and size");
    if (!source.scenario.obstacles.empty()) {
      map.Legend([](SvgCanvas& canvas,
                    const Point& at) { canvas.Circle(at, 5.0, {.fill = palette::kMapInk}); },
                 "obstacle");
    }
  }
  map.ColorBar([top](double share) { return HeightColor(share * top, top); }, "bottom only",
               fmt::format("up to {:g} m", top), "Seen, by height above bottom");
}

void DrawTrueObjects(MapAxes& map, const FigureSource& source) {
  for (const ScenarioOpi& opi : source.scenario.opis) {
    const auto place = opi.Place(source.record.name);
    if (!place) continue;
    DrawTruth(map, *place, opi.radius_m);
    map.canvas().Text(map.At(place->head<2>()) + Point(11.0, -9.0), opi.name,
                      {.fill = palette::kMapInk, .is_bold = true, .has_halo = true});
  }
}

/// A column as a polygon of many sides, north and east of its middle in units of its half size.
std::vector<Eigen::Vector2d> OutlineOf(const UprightBody& body) {
  if (!body.is_column()) return {{-1.0, -1.0}, {-1.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}};
  constexpr int kSides = 24;
  std::vector<Eigen::Vector2d> corners;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kSides;
    corners.emplace_back(std::cos(angle), std::sin(angle));
  }
  return corners;
}

void DrawObstacles(MapAxes& map, const Scenario& scenario) {
  for (const UprightBody& body : BodiesOf(scenario)) {
    std::vector<Point> corners;
    for (const Eigen::Vector2d& corner : OutlineOf(body)) {
      const Eigen::Vector2d at = body.center_W() + corner.cwiseProduct(body.half_size());
      corners.push_back(map.At(at));
    }
    map.canvas().Polygon(corners, {.fill = palette::kMapInk, .stroke = palette::kMapInk});
  }
}

/// Where the vehicle set out: the scenario's start, or else what the mission manager said.
void DrawStart(MapAxes& map, const FigureSource& source) {
  if (source.score.has_truth) {
    const auto& start = source.scenario.start;
    DrawHome(map.canvas(), map.At({start.north_m, start.east_m}));
  } else if (source.record.home) {
    DrawHome(map.canvas(), map.At({source.record.home->north, source.record.home->east}));
  }
}

void DrawTracks(MapAxes& map, const FigureSource& source) {
  if (source.score.has_truth) {
    const std::vector<Point> track = PointsOf(map, source.record.truth);
    map.canvas().Polyline(track, kPathHalo);
    map.canvas().Polyline(track, kTruePath);
  }
  map.canvas().Polyline(PointsOf(map, source.record.nav), kEstimatedPath);
  DrawDirection(map, WayOf(source));
}

}  // namespace

Figure TrackFigure(const FigureSource& source) {
  const SessionRecord& record = source.record;
  const auto footprint = source.settings.footprint_m();
  const SurveyArea area = AreaOf(record);
  MapAxes map(
      WidenedTo(WayOf(source), area),  // start and home may lie far outside
      fmt::format("Where it went and what it chose: {} m of way", std::lround(source.score.path_m)),
      fmt::format("{} \u00b7 image {:.2f} \u00d7 {:.2f} m on the bottom", RunName(source),
                  footprint[0], footprint[1]));
  map.BeginMap();
  map.Raster(record.grid, [&](const SeenCell& cell) {
    return HeightColor(static_cast<double>(cell.seen_height), area.object_height_max);
  });
  map.Outline(area);
  DrawDecisions(map, record.decisions);
  DrawTracks(map, source);
  DrawDecisionPoints(map, record.decisions);
  if (source.score.has_truth) {
    DrawObstacles(map, source.scenario);
    DrawTrueObjects(map, source);
  }
  DrawStart(map, source);
  map.EndMap();
  DrawTrackLegend(map, source, area.object_height_max);
  return {
      record.name + "_track.svg",
      "The ground is shaded by the greatest height above the bottom up to which the vehicle "
      "believes to have seen it; grey was never seen. Dots mark where the helm decided; "
      "their colour says whose bid decided: the behavior that gave the chosen path the largest "
      "part "
      "of its worth per metre, or whose cost ruled out the option that would else have won. Thin "
      "lines lead to the ends of the three best options. The dashed line is the area to survey.",
      map.Finish()};
}

}  // namespace limpet
