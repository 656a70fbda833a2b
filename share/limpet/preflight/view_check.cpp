// SPDX-License-Identifier: MIT
// Whether the camera sees, from the survey altitude, what the survey is to find.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limpet/preflight/checks.hpp"
#include "limpet/survey/band_top.hpp"
#include "limpet/survey/detection_chance.hpp"
#include "limpet/vision/box_model.hpp"

namespace limpet::internal {
namespace {

void CheckHighestView(const MissionReading& reading, const SurveyFacts& survey,
                      MissionProblems& found) {
  const auto highest = reading.Find("pMap", "highest_view_m");
  if (!highest) return;
  const double altitude = survey.altitude.number();
  const auto tolerance = reading.Find("pSurvey", "altitude_tolerance_m");
  if (altitude > highest->number()) {
    found.geometry.push_back(survey.altitude.Refuse(
        fmt::format("from {:g} m nothing is seen: pMap uses no frame from higher than {}; allowed: "
                    "up to {:g} m, or a higher highest_view_m",
                    altitude, highest->Named(), highest->number())));
  } else if (altitude + tolerance->number() > highest->number()) {
    found.notes.push_back(survey.altitude.Refuse(
        fmt::format("is within altitude_tolerance_m of {}: frames from above it show nothing",
                    highest->Named())));
  }
}

/// True if the image is wider than nothing where objects float highest.
bool SeesTheBand(const MissionReading& reading, const SurveyFacts& survey, MissionProblems& found) {
  const double altitude = survey.altitude.number(), band = survey.band.number();
  const auto radius = reading.Find("pMap", "object_radius_m");
  const BandView view{.object_height_max = band,
                      .object_radius = radius ? radius->number() : 0.0,
                      .altitude = altitude};
  if (const auto problem = ProblemOf(view, survey.altitude.Named())) {
    found.geometry.push_back(survey.band.Refuse(*problem));
    return false;
  }
  const Footprint footprint = survey.footprint();
  if (footprint.half_across(Footprint::kTop) <= 0.0 ||
      footprint.half_along(Footprint::kTop) <= 0.0) {
    found.geometry.push_back(survey.band.Refuse(fmt::format(
        "{:g} m below the camera the image is too small to hold an object; allowed: lower objects, "
        "a higher altitude_m or a wider camera",
        altitude - band)));
    return false;
  }
  return true;
}

void CheckPixels(const MissionReading& reading, const SurveyFacts& survey, MissionProblems& found) {
  const auto radius = reading.Find("pMap", "object_radius_m");
  if (!radius) return;
  const double least_px = BoxModelConstants{}.least_radius_px;
  const double focal_px = std::min(survey.camera.fx, survey.camera.fy);
  const double radius_px = focal_px * radius->number() / survey.altitude.number();
  if (radius_px < least_px) {
    found.geometry.push_back(survey.altitude.Refuse(fmt::format(
        "from {:g} m an object of {} is {:.1f} px in the image, and the detector finds none "
        "below {:g} px; allowed: up to {:.2f} m with this camera",
        survey.altitude.number(), radius->Named(), radius_px, least_px,
        focal_px * radius->number() / least_px)));
  }
}

/// An object at the top of the band must be in enough frames of one pass.
void CheckFrames(const MissionReading& reading, const SurveyFacts& survey, MissionProblems& found) {
  const auto rate = reading.Find("uSimCamera", "rate_hz");
  const auto looks = reading.Find("pNav", "looks_to_confirm");
  if (!rate || !looks || survey.speed.number() <= 0.0) return;
  const double length = 2.0 * survey.footprint().half_along(Footprint::kLayers - 1);
  const double frames = length * rate->number() / survey.speed.number();
  if (frames < looks->number()) {
    found.geometry.push_back(survey.speed.Refuse(fmt::format(
        "an object at the top of the band is in {:.1f} frames of a pass ({:.2f} m of image at {}), "
        "and {} are needed; allowed: up to {:.2f} m/s",
        frames, length, rate->Named(), looks->Named(), length * rate->number() / looks->number())));
  }
}

/// The simulated detector.
BoxModelConstants DetectorOf(const MissionReading& reading) {
  BoxModelConstants model;
  const auto take = [&reading](const char* key, double& value) {
    if (const auto setting = reading.Find("uSimCamera", key)) value = setting->number();
  };
  take("box_peak", model.peak);
  take("box_faint_at", model.faint_at);
  take("box_faint_width", model.faint_width);
  return model;
}

/// How likely it finds an object at a range that is so many times the visibility.
double ChanceAt(const BoxModelConstants& model, double range) {
  return model.peak / (1.0 + std::exp((range - model.faint_at) / model.faint_width));
}

/// The range, in visibilities, at which it finds one with this chance. REQUIRES: below its peak.
double RangeOf(const BoxModelConstants& model, double chance) {
  return model.faint_at + model.faint_width * std::log(model.peak / chance - 1.0);
}

/// The vehicle finds out what the water is like, so what a mission expects of it is worth a note
/// only.
void CheckVisibility(const MissionReading& reading, const SurveyFacts& survey,
                     MissionProblems& found) {
  const auto expected = reading.Find("pMap", "visibility_m");
  if (!expected) return;
  const double altitude = survey.altitude.number();
  DetectionModel model{.visibility = Meters(expected->number())};
  if (const auto share = reading.Find("pMap", "detection_half_range"))
    model.half_range = share->number();
  if (altitude > HalfRange(model)) {
    found.notes.push_back(survey.altitude.Refuse(
        fmt::format("from {:g} m the seabed is not in sight in water of {}: up to {:.2f} m it is",
                    altitude, expected->Named(), HalfRange(model))));
  }
}

void CheckSimulatedWater(const MissionReading& reading, const SurveyFacts& survey,
                         MissionProblems& found) {
  if (!reading.scenario() || !reading.Launches("uSimCamera")) return;
  constexpr double kPoor = 0.9;
  constexpr double kNone = 0.01;  // fewer: what the survey is for is never found
  constexpr double kFair = 0.5;   // of the frames, by what is proposed in its place
  const double visibility = reading.scenario()->water.visibility_m;
  const double altitude = survey.altitude.number();
  const BoxModelConstants model = DetectorOf(reading);
  const double chance = ChanceAt(model, altitude / visibility);
  if (chance >= kPoor) return;
  const std::string text = fmt::format(
      "from {:g} m an object on the seabed is found in {:.0f} % of the frames only, "
      "in water of visibility_m {:g} ({}:{})",
      altitude, 100.0 * chance, visibility, reading.InScenario("visibility_m:").file,
      reading.InScenario("visibility_m:").line);
  if (chance >= kNone || model.peak <= kFair) {
    found.notes.push_back(survey.altitude.Refuse(text));
  } else {
    found.geometry.push_back(survey.altitude.Refuse(
        fmt::format("{}: the survey would find nothing; allowed: up to {:.2f} m, from where it is "
                    "found in half of them",
                    text, visibility * RangeOf(model, kFair))));
  }
}

}  // namespace

void CheckView(const MissionReading& reading, const SurveyFacts& survey, MissionProblems& found) {
  CheckHighestView(reading, survey, found);
  if (SeesTheBand(reading, survey, found)) {
    CheckFrames(reading, survey, found);
  }
  CheckPixels(reading, survey, found);
  CheckVisibility(reading, survey, found);
  CheckSimulatedWater(reading, survey, found);
}

}  // namespace limpet::internal
