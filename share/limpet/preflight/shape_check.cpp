// SPDX-License-Identifier: MIT
// An area of its own shape: room to turn, what cannot be seen, zones in the way.
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "limpet/planning/region.hpp"
#include "limpet/planning/room.hpp"
#include "limpet/preflight/checks.hpp"
#include "limpet/preflight/unseen_ground.hpp"

namespace limpet::internal {
namespace {

std::string PlaceText(const PlanePoint& at) {
  return fmt::format("x {:.1f}, y {:.1f}", at.y(), at.x());
}

std::optional<PlanePoint> StartOf(const MissionReading& reading) {
  if (!reading.scenario()) return std::nullopt;
  const Scenario::Start& start = reading.scenario()->start;
  return PlanePoint(start.north_m, start.east_m);
}

void CheckUnseen(const MissionReading& reading, const SurveyFacts& survey, const Region& region,
                 MissionProblems& found) {
  const Setting radius = reading.Find("pHelm", "turning_radius_m").value();
  const Setting target = reading.Find("pSurvey", "coverage_target").value();
  const std::optional<PlanePoint> start = StartOf(reading);
  const auto unseen = UnseenGround(survey, region, start);
  if (!unseen) {
    const bool is_anywhere = UnseenGround(survey, region, std::nullopt).has_value();
    found.geometry.push_back(survey.area_line().Refuse(fmt::format(
        "a full turn of {} fits nowhere into the operating region{}", radius.Named(),
        is_anywhere ? fmt::format(" where it hangs together with the start, {}", PlaceText(*start))
                    : "")));
    return;
  }
  constexpr double kWorthSaying = 0.002;
  if (unseen->share < kWorthSaying) return;
  const std::string text = fmt::format(
      "about {:.1f} % of the area cannot be seen from where the vehicle may be and turn{}, first "
      "of "
      "all around {}",
      100.0 * unseen->share,
      unseen->is_start_shut_off
          ? fmt::format(" from its start on, {}, which is shut off from where there is more room",
                        PlaceText(*start))
          : "",
      PlaceText(unseen->farthest_W));
  if (unseen->share > 1.0 - target.number()) {
    found.geometry.push_back(survey.area_line().Refuse(
        fmt::format("{}; with {} the survey never ends", text, target.Named())));
  } else {
    found.notes.push_back(survey.area_line().Refuse(text));
  }
}

/// The start, and the way from there.
void CheckWayIn(const MissionReading& reading, const SurveyFacts& survey, const Region& region,
                const SurveyShape& shape, MissionProblems& found) {
  const std::optional<PlanePoint> start = StartOf(reading);
  if (!start) return;
  const PlanePoint& from = *start;
  for (const SimplePolygon& zone : shape.zones()) {
    if (zone.Contains(from)) {
      found.geometry.push_back(
          {reading.InScenario("start:"), "start", "lies in a keep-out zone of the mission"});
      return;
    }
  }
  std::vector<PlanePoint> way = shape.transit();
  const PlanePoint last = way.empty() ? from : way.back();
  if (const auto entry = NearestRoom(*region.free_space(), last, survey.turning_radius)) {
    way.push_back(*entry);
  }
  if (region.Contains(from)) return;
  PlanePoint at = from;
  for (const PlanePoint& next : way) {
    const PlanePoint leg = next - at;
    const DubinsPath line(Pose2{at.x(), at.y(), std::atan2(leg.y(), leg.x())},
                          {{.curvature = 0.0, .length = leg.norm()}});
    if (region.EntersZone(line)) {
      found.geometry.push_back(
          reading.Find("pSurvey", "transit")
              ->Refuse(fmt::format(
                  "a keep-out zone bars the way from the start to the area, between {} and {}",
                  PlaceText(at), PlaceText(next))));
      return;
    }
    at = next;
  }
}

}  // namespace

void CheckShape(const MissionReading& reading, const SurveyFacts& survey, MissionProblems& found) {
  const auto shape = SurveyShape::Of(survey.area);
  if (!shape || shape->is_plain()) return;
  const Region region(survey.area, Meters(reading.Find("pHelm", "tracking_allowance_m")->number()));
  CheckUnseen(reading, survey, region, found);
  CheckWayIn(reading, survey, region, *shape, found);
}

}  // namespace limpet::internal
