// SPDX-License-Identifier: MIT
// The area: its extent, room to turn, what lies in it, and the grids that hold it.
#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "limpet/mission/seabed.hpp"
#include "limpet/preflight/checks.hpp"
#include "limpet/survey/grid_frame.hpp"
#include "limpet/survey/survey_shape.hpp"

namespace limpet::internal {
namespace {

bool CheckExtent(const MissionReading& reading, const SurveyFacts& survey, MissionProblems& found) {
  if (survey.problem) {
    const auto& [key, text, is_unreadable] = *survey.problem;
    auto& list = is_unreadable ? found.syntax : found.geometry;
    list.push_back(reading.Find("pSurvey", key)->Refuse(text));
    return false;
  }
  const auto is_empty = [&](const Setting& low, const Setting& high) {
    if (low.number() < high.number()) return false;
    found.geometry.push_back(
        high.Refuse(fmt::format("`{}` leaves no area; allowed: above {}", high.text, low.Named())));
    return true;
  };
  if (survey.outline.is_default && (is_empty(survey.north_min, survey.north_max) ||
                                    is_empty(survey.east_min, survey.east_max))) {
    return false;
  }
  const auto cell = reading.Find("pMap", "cell_m");
  const double cell_m = cell ? cell->number() : kGridCell_m;
  const double cells = survey.north_extent() * survey.east_extent() / (cell_m * cell_m);
  if (cells > kMostGridCells) {
    const double side_m = std::sqrt(kMostGridCells) * cell_m;
    found.geometry.push_back(survey.area_line().Refuse(
        fmt::format("an area of {:.0f} x {:.0f} m has {:.3g} cells of {:g} m; allowed: {:g} cells, "
                    "e.g. {:.0f} x "
                    "{:.0f} m",
                    survey.north_extent(), survey.east_extent(), cells, cell_m, kMostGridCells,
                    side_m, side_m)));
    return false;
  }
  return true;
}

void CheckTurns(const MissionReading& reading, const SurveyFacts& survey, MissionProblems& found) {
  const Setting radius = reading.Find("pHelm", "turning_radius_m").value();
  const Setting allowance = reading.Find("pHelm", "tracking_allowance_m").value();
  const double rim = std::max(0.0, survey.area.margin - allowance.number());
  const double narrow = std::min(survey.north_extent(), survey.east_extent()) + 2.0 * rim;
  const auto shape = SurveyShape::Of(survey.area);
  if (shape && shape->is_plain() && narrow < 2.0 * radius.number()) {
    found.geometry.push_back(radius.Refuse(
        fmt::format("area and margin leave {:.1f} m, a turn of {:g} m radius needs {:.1f} m; "
                    "allowed: up to {:.2f} m",
                    narrow, radius.number(), 2.0 * radius.number(), 0.5 * narrow)));
  }
  const auto rate = reading.Find("pPilot", "max_turn_rate_degps");
  if (rate && survey.speed.number() > 0.0) {
    const double fastest = RadiansFromDegrees(rate->number()) * radius.number();
    if (survey.speed.number() > fastest) {
      found.geometry.push_back(survey.speed.Refuse(
          fmt::format("`{}` is too fast for turns of {} at {}; allowed: up to {:.2f} m/s",
                      survey.speed.text, radius.Named(), rate->Named(), fastest)));
    }
  }
  if (survey.area.margin < allowance.number()) {
    found.notes.push_back(allowance.Refuse(
        fmt::format("is more than the margin, {}: the pilot's error may lead out of the region",
                    reading.Find("pSurvey", "margin_m")->Named())));
  }
}

void CheckCells(const MissionReading& reading, const SurveyFacts& survey, MissionProblems& found) {
  const auto cell = reading.Find("pMap", "cell_m");
  const auto voxel = reading.Find("pMap", "voxel_m");
  const auto radius = reading.Find("pMap", "object_radius_m");
  if (!cell || !voxel || !radius) return;
  if (cell->number() != kGridCell_m) {
    found.geometry.push_back(
        cell->Refuse(fmt::format("pHelm mirrors the map with cells of {:g} m and would see nothing "
                                 "of it; allowed: {:g} m",
                                 kGridCell_m, kGridCell_m)));
  }
  const Footprint footprint = survey.footprint();
  const double image =
      2.0 * std::min(footprint.half_across(Footprint::kTop), footprint.half_along(Footprint::kTop));
  if (cell->number() > 0.5 * image) {
    found.geometry.push_back(cell->Refuse(fmt::format(
        "a cell of {:g} m is too large for an image of {:.2f} m at the top of the band; "
        "allowed: up to {:.2f} m",
        cell->number(), image, 0.5 * image)));
  }
  if (voxel->number() > 2.0 * radius->number()) {
    found.geometry.push_back(voxel->Refuse(
        fmt::format("a voxel of {:g} m is larger than an object of {}; allowed: up to {:g} m",
                    voxel->number(), radius->Named(), 2.0 * radius->number())));
  }
}

/// An object in one session.
struct ObjectPlace {
  const ScenarioOpi& opi;
  const std::string& session;
  Eigen::Vector3d p_W;  ///< [m]
};

/// Checks where an object is, against what the mission surveys.
void CheckPlace(const MissionReading& reading, const SurveyFacts& survey, const Seabed& seabed,
                const ObjectPlace& object, MissionProblems& found) {
  const auto& [opi, session, place] = object;
  const SourceLine where = reading.InScenario(opi.name);
  const auto refuse = [&](const std::string& text) {
    found.geometry.push_back({where, object.opi.name, object.session + " " + text});
  };
  const SurveyArea& area = survey.area;
  if (survey.Outside(place.head<2>()) > 0.0) {
    refuse(fmt::format("[{:g}, {:g}] is outside the area: {}north {:g} to {:g}, east {:g} to {:g}",
                       place.x(), place.y(), area.outline ? "a polygon within " : "",
                       area.north_min, area.north_max, area.east_min, area.east_max));
    return;
  }
  if (const auto shape = SurveyShape::Of(area); shape && !shape->Wants(place.head<2>())) {
    const bool is_inside = shape->outline().Contains(place.head<2>());
    refuse(fmt::format("[{:g}, {:g}] is {}, where nobody looks", place.x(), place.y(),
                       is_inside ? "in a keep-out zone" : "on the border of the area"));
    return;
  }
  const double down = seabed.Depth(place.head<2>());
  const double height = down - place.z();
  if (height < -opi.radius_m || place.z() < opi.radius_m) {
    refuse(fmt::format("depth {:g} is not between the surface and the seabed at {:.2f} m",
                       place.z(), down));
  } else if (height + opi.radius_m >= survey.altitude.number()) {
    refuse(fmt::format("reaches {:.2f} m above the seabed, where the vehicle flies: {}",
                       height + opi.radius_m, survey.altitude.Named()));
  } else if (height > survey.band.number() + opi.radius_m) {
    refuse(fmt::format("floats {:.2f} m above the seabed, where nobody looks: {}", height,
                       survey.band.Named()));
  }
}

}  // namespace

bool CheckArea(const MissionReading& reading, const SurveyFacts& survey, MissionProblems& found) {
  if (!CheckExtent(reading, survey, found)) return false;
  CheckTurns(reading, survey, found);
  CheckShape(reading, survey, found);
  CheckCells(reading, survey, found);
  return true;
}

void CheckObjects(const MissionReading& reading, const SurveyFacts& survey,
                  MissionProblems& found) {
  if (!reading.scenario()) return;
  const Seabed seabed(reading.scenario()->seabed);
  for (const ScenarioOpi& opi : reading.scenario()->opis) {
    for (const auto& [session, place] : opi.places) {
      if (place) CheckPlace(reading, survey, seabed, {opi, session, *place}, found);
    }
  }
}

}  // namespace limpet::internal
