// SPDX-License-Identifier: MIT
#include "limpet/preflight/survey_facts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limpet/core/camera_params.hpp"
#include "limpet/core/params.hpp"

namespace limpet {
namespace {

CameraModel CameraOf(const MissionReading& reading, const char* app) {
  CameraParams camera;
  for (const ParamSpec& spec : DescribeParams(camera)) {
    if (const auto setting = reading.Find(app, spec.name)) {
      static_cast<void>(spec.set(setting->text));  // its problems are syntax
    }
  }
  return camera.geometry();
}

/// Half the width of the image that counts for the target [m].
double HalfWidth(const Footprint& footprint, const std::string& coverage_kind) {
  if (coverage_kind == "seabed") return footprint.half_across(0);
  if (coverage_kind == "band") return 0.5 * footprint.swath();
  return footprint.half_across(Footprint::kLayers - 1);
}

}  // namespace

double SurveyFacts::Outside(double north, double east) const {
  const double dn = std::max({area.north_min - north, north - area.north_max, 0.0});
  const double de = std::max({area.east_min - east, east - area.east_max, 0.0});
  return std::hypot(dn, de);
}

std::optional<SurveyFacts> ReadSurveyFacts(const MissionReading& reading) {
  if (!reading.Launches("pSurvey") || !reading.Launches("pHelm")) return std::nullopt;
  const auto survey = [&](const char* key) { return reading.Find("pSurvey", key).value(); };
  SurveyFacts facts{.area = {},
                    .north_min = survey("area_north_min_m"),
                    .north_max = survey("area_north_max_m"),
                    .east_min = survey("area_east_min_m"),
                    .east_max = survey("area_east_max_m"),
                    .altitude = survey("altitude_m"),
                    .band = survey("object_height_max_m"),
                    .camera = CameraOf(reading, "pHelm"),
                    .speed = {},
                    .turning_radius = reading.Find("pHelm", "turning_radius_m").value().number()};
  facts.area = {.north_min = facts.north_min.number(),
                .north_max = facts.north_max.number(),
                .east_min = facts.east_min.number(),
                .east_max = facts.east_max.number(),
                .margin = survey("margin_m").number(),
                .object_height_max = facts.band.number()};
  const std::vector<Setting> speeds = reading.OfBehaviors("BHV_FollowPath", "speed_mps");
  if (!speeds.empty()) facts.speed = speeds.front();
  return facts;
}

PathEstimate EstimatePath(const SurveyFacts& survey, const std::string& coverage_kind,
                          double coverage_target) {
  const double width = 2.0 * HalfWidth(survey.footprint(), coverage_kind);
  if (width <= 0.0) return {};
  const double lanes_m = coverage_target * survey.north_extent() * survey.east_extent() / width;
  // Lanes run along the longer side: fewer turns. A half circle is the least that a turn takes.
  const double lanes = lanes_m / std::max(survey.north_extent(), survey.east_extent());
  const double turns_m =
      std::max(0.0, std::ceil(lanes) - 1.0) * std::numbers::pi * survey.turning_radius;
  return {.lanes_m = lanes_m, .turns_m = turns_m};
}

}  // namespace limpet
