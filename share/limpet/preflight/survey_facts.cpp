// SPDX-License-Identifier: MIT
#include "limpet/preflight/survey_facts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limpet/core/camera_params.hpp"
#include "limpet/core/params.hpp"
#include "limpet/survey/survey_shape.hpp"

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

/// pSurvey's parameters as the mission gives them.
SurveyParams ParamsOf(const MissionReading& reading) {
  SurveyParams params;
  for (const ParamSpec& spec : DescribeParams(params)) {
    for (const Setting& setting : reading.FindAll("pSurvey", spec.name)) {
      if (!setting.is_default) static_cast<void>(spec.set(setting.text));  // problems are syntax
    }
  }
  return params;
}

void TakeArea(const MissionReading& reading, SurveyFacts& facts) {
  auto area = AreaOf(ParamsOf(reading), {.folder = reading.folder(),
                                         .latitude = reading.mission().Global("LatOrigin"),
                                         .longitude = reading.mission().Global("LongOrigin")});
  if (!area) {
    facts.problem = area.error();
    return;
  }
  facts.area = *std::move(area);
  if (facts.area.north_max <= facts.area.north_min || facts.area.east_max <= facts.area.east_min) {
    return;  // there are words for it
  }
  const auto shape = SurveyShape::Of(facts.area);
  if (!shape) {
    facts.problem = {.key = facts.area.keep_out ? "keep_out" : "area", .text = shape.error().text};
    return;
  }
  facts.wanted_m2 = shape->WantedArea();
}

}  // namespace

double SurveyFacts::Outside(const Eigen::Vector2d& p_W) const {
  return SurveyShape::Of(area)->OutsideArea(p_W);
}

std::optional<SurveyFacts> ReadSurveyFacts(const MissionReading& reading) {
  if (!reading.Launches("pSurvey") || !reading.Launches("pHelm")) return std::nullopt;
  const auto survey = [&](const char* key) { return reading.Find("pSurvey", key).value(); };
  SurveyFacts facts{.area = {},
                    .north_min = survey("area_north_min_m"),
                    .north_max = survey("area_north_max_m"),
                    .east_min = survey("area_east_min_m"),
                    .east_max = survey("area_east_max_m"),
                    .outline = survey("area"),
                    .altitude = survey("altitude_m"),
                    .band = survey("object_height_max_m"),
                    .camera = CameraOf(reading, "pHelm"),
                    .speed = {},
                    .turning_radius = reading.Find("pHelm", "turning_radius_m").value().number()};
  const Setting file = survey("area_geojson");
  if (!file.is_default) facts.outline = file;
  TakeArea(reading, facts);
  const std::vector<Setting> speeds = reading.OfBehaviors("BHV_FollowPath", "speed_mps");
  if (!speeds.empty()) facts.speed = speeds.front();
  return facts;
}

PathEstimate EstimatePath(const SurveyFacts& survey, const std::string& coverage_kind,
                          double coverage_target) {
  const double width = 2.0 * HalfWidth(survey.footprint(), coverage_kind);
  if (width <= 0.0) return {};
  const double lanes_m = coverage_target * survey.wanted_m2 / width;
  // Lanes run along the longer side: fewer turns. A half circle is the least that a turn takes.
  const double lanes = lanes_m / std::max(survey.north_extent(), survey.east_extent());
  const double turns_m =
      std::max(0.0, std::ceil(lanes) - 1.0) * std::numbers::pi * survey.turning_radius;
  return {.lanes_m = lanes_m, .turns_m = turns_m};
}

}  // namespace limpet
