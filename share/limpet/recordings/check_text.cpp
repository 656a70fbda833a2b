// SPDX-License-Identifier: MIT
#include "limpet/recordings/check_text.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limpet/core/harmless_text.hpp"

namespace limpet {
namespace {

using Json = nlohmann::ordered_json;

/// A line of a report: what it is about, and what of it.
std::string Line(const char* subject, const std::string& text) {
  return fmt::format("  {:<30}{}\n", subject, text);
}

std::string ShareText(std::size_t part, std::size_t of) {
  return fmt::format("{} of {} ({:.1f} %)", part, of,
                     of > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(of) : 0.0);
}

std::string TimesText(const SampleTimes& times) {
  std::string text =
      fmt::format("{} in {:.1f} s, {:.2f} per second, longest pause {:.2f} s", times.count,
                  times.last - times.first, times.Rate(), times.longest_pause);
  if (times.untimely > 0) text += fmt::format("; {} not later than the one before", times.untimely);
  return text;
}

std::string DifferencesText(const Differences& found, const char* unit) {
  if (found.count == 0) return "cannot be compared: there is none";
  return fmt::format("median {:.4f} {}, 95 % within {:.4f}, greatest {:.4f}, of {}", found.median,
                     unit, found.within_95, found.greatest, found.count);
}

std::string PathText(const PathLength& path) {
  return fmt::format("{:.1f} m in {:.1f} s; {:.1f} s lie in pauses of more than 1 s", path.length,
                     path.covered, path.left_out);
}

/// From 0 up to 360, as whole degrees are shown.
double UnsignedDegrees(Radians angle) {
  const double degrees = std::round(angle.in_text_unit());
  return degrees < 0.0 ? degrees + 360.0 : degrees + 0.0;
}

std::string GeometryText(const std::optional<BeamGeometry>& geometry) {
  if (!geometry) {
    return "cannot be told: fewer than 20 pings have four beams' speeds and a velocity, or they "
           "hardly move";
  }
  const auto tilts = geometry->tilts(), azimuths = geometry->azimuths();
  std::string text;
  for (std::size_t beam = 0; beam < tilts.size(); ++beam) {
    text += fmt::format("{}{:.1f} at {:.0f}", beam > 0 ? ", " : "", tilts[beam].in_text_unit(),
                        UnsignedDegrees(azimuths[beam]));
  }
  return text + fmt::format(" deg; estimated from {} pings", geometry->pings());
}

std::string BeamsText(const DvlCheck& dvl) {
  std::string text =
      Line("good beams", fmt::format("four in {}, three in {}, fewer in {}", dvl.four_beams,
                                     dvl.three_beams, dvl.fewer_beams));
  text += Line("beams from the vertical", GeometryText(dvl.geometry));
  if (!dvl.geometry) return text;
  text += Line("  four beams - instrument", DifferencesText(dvl.four, "m/s"));
  text += Line("  three beams - instrument", DifferencesText(dvl.three, "m/s"));
  text += Line("  beams' contradiction", DifferencesText(dvl.contradiction, "m/s"));
  text += Line("  velocity to be had", fmt::format("from three or four beams in {} pings for which "
                                                   "the instrument gives none",
                                                   dvl.velocity_from_beams));
  return text;
}

std::string DvlText(const DvlCheck& dvl) {
  const std::size_t pings = dvl.times.count;
  std::string text = "DVL\n" + Line("pings", TimesText(dvl.times));
  text += Line("bottom lock",
               ShareText(dvl.with_velocity, pings) +
                   fmt::format(", longest without {:.2f} s", dvl.longest_without_velocity));
  const bool has_beams = dvl.four_beams + dvl.three_beams > 0;
  text += has_beams ? BeamsText(dvl) : Line("beams' speeds", "none: cannot be compared");
  text += Line("altitude", ShareText(dvl.with_altitude, pings));
  if (dvl.altitude) {
    text += Line(("  - " + dvl.altitude->rule).c_str(),
                 DifferencesText(dvl.altitude->differences, "m"));
  }
  const GateVerdicts& gate = dvl.gate;
  text +=
      Line("velocity gate", fmt::format("passes {}, believes {} after a contest, refuses {}, "
                                        "holds {} as contested",
                                        gate.good, gate.believed, gate.refused, gate.contested));
  text += Line("path by all velocities", PathText(dvl.path));
  return text + Line("path by those that pass", PathText(dvl.gated_path));
}

std::string DepthText(const DepthCheck& depth) {
  return "Depth\n" + Line("samples", TimesText(depth.times)) +
         Line("range", fmt::format("{:.2f} to {:.2f} m", depth.least, depth.greatest)) +
         Line("rate over 2 s", fmt::format("at most {:.2f} m/s down, {:.2f} m/s up",
                                           depth.fastest_down, depth.fastest_up));
}

/// Size of the correlation below which the depth's rate and the DVL's say nothing of one another.
constexpr double kLeastCorrelation = 0.3;

std::string VerticalText(const VerticalAgreement& vertical) {
  std::string text =
      Line("DVL's third axis", fmt::format("{:.2f} times the depth's rate, correlation "
                                           "{:.2f}, of {} pings",
                                           vertical.slope, vertical.correlation, vertical.count));
  if (vertical.correlation < -kLeastCorrelation) {
    text += Line("",
                 "runs against the depth: it points up, or the velocity is the seabed's "
                 "relative to the vehicle");
  }
  return text;
}

std::string OwnText(const OwnNavigationCheck& own) {
  std::string text = "Own navigation\n";
  const auto add = [&text](const char* subject, const std::optional<SampleTimes>& times) {
    text += Line(subject, times ? TimesText(*times) : "none");
  };
  add("places", own.places);
  add("headings", own.headings);
  add("speeds", own.speeds);
  text += Line("path", fmt::format("{:.1f} m by its places, {:.1f} m by its speeds",
                                   own.path_of_places, own.path_of_speeds));
  text += Line("  speed of places - said", DifferencesText(own.speed, "m/s"));
  Differences course = own.course;
  for (double* angle : {&course.median, &course.within_95, &course.greatest})
    *angle = Radians(*angle).in_text_unit();
  return text + Line("  course of places - heading", DifferencesText(course, "deg"));
}

Json JsonOf(const SampleTimes& times) {
  return {{"count", times.count},
          {"first_s", times.first},
          {"last_s", times.last},
          {"rate_hz", times.Rate()},
          {"longest_pause_s", times.longest_pause},
          {"untimely", times.untimely}};
}

Json JsonOf(const Differences& found) {
  if (found.count == 0) return nullptr;
  return {{"count", found.count},
          {"median", found.median},
          {"within_95", found.within_95},
          {"greatest", found.greatest}};
}

Json JsonOf(const PathLength& path) {
  return {{"length_m", path.length}, {"covered_s", path.covered}, {"left_out_s", path.left_out}};
}

Json JsonOf(const std::optional<BeamGeometry>& geometry) {
  if (!geometry) return nullptr;
  Json tilts = Json::array(), azimuths = Json::array();
  for (const Radians tilt : geometry->tilts())
    tilts.push_back(tilt.in_text_unit());
  for (const Radians azimuth : geometry->azimuths())
    azimuths.push_back(azimuth.in_text_unit());
  return {{"pings", geometry->pings()},
          {"from_vertical_deg", tilts},
          {"azimuth_deg", azimuths},
          {"lengths", geometry->lengths()}};
}

Json JsonOf(const DvlCheck& dvl) {
  Json altitude = nullptr;
  if (dvl.altitude) {
    altitude = {{"rule", dvl.altitude->rule}, {"differences_m", JsonOf(dvl.altitude->differences)}};
  }
  return {{"pings", JsonOf(dvl.times)},
          {"with_velocity", dvl.with_velocity},
          {"with_altitude", dvl.with_altitude},
          {"longest_without_velocity_s", dvl.longest_without_velocity},
          {"four_beams", dvl.four_beams},
          {"three_beams", dvl.three_beams},
          {"fewer_beams", dvl.fewer_beams},
          {"velocity_from_beams_alone", dvl.velocity_from_beams},
          {"geometry", JsonOf(dvl.geometry)},
          {"four_beams_to_instrument_mps", JsonOf(dvl.four)},
          {"three_beams_to_instrument_mps", JsonOf(dvl.three)},
          {"contradiction_mps", JsonOf(dvl.contradiction)},
          {"altitude", altitude},
          {"gate",
           {{"good", dvl.gate.good},
            {"believed", dvl.gate.believed},
            {"refused", dvl.gate.refused},
            {"contested", dvl.gate.contested}}},
          {"path", JsonOf(dvl.path)},
          {"gated_path", JsonOf(dvl.gated_path)}};
}

Json JsonOf(const DepthCheck& depth) {
  return {{"samples", JsonOf(depth.times)},
          {"least_m", depth.least},
          {"greatest_m", depth.greatest},
          {"fastest_down_mps", depth.fastest_down},
          {"fastest_up_mps", depth.fastest_up}};
}

Json JsonOf(const OwnNavigationCheck& own) {
  const auto times = [](const std::optional<SampleTimes>& samples) {
    return samples ? JsonOf(*samples) : Json(nullptr);
  };
  return {{"places", times(own.places)},
          {"headings", times(own.headings)},
          {"speeds", times(own.speeds)},
          {"path_of_places_m", own.path_of_places},
          {"path_of_speeds_m", own.path_of_speeds},
          {"speed_mps", JsonOf(own.speed)},
          {"course_rad", JsonOf(own.course)}};
}

}  // namespace

std::string MissingText(const Recording& recording) {
  std::string text;
  for (const MissingData& missing : recording.missing)
    text += fmt::format("  {}: {}; {}\n", missing.what, missing.reason, missing.cost);
  return text;
}

std::string CheckText(const Recording& recording, const RecordingCheck& check) {
  std::string text = HarmlessText(recording.name) + "\n";
  if (check.dvl) text += DvlText(*check.dvl);
  if (check.own) text += OwnText(*check.own);
  if (check.depth) text += DepthText(*check.depth);
  if (check.vertical) text += VerticalText(*check.vertical);
  if (!recording.missing.empty()) text += "Missing\n" + MissingText(recording);
  if (!recording.left_out.empty()) text += "Left out\n";
  for (const std::string& left_out : recording.left_out)
    text += "  " + left_out + "\n";
  if (!recording.doubts.empty()) text += "In doubt\n";
  for (const std::string& doubt : recording.doubts)
    text += "  " + doubt + "\n";
  return text;
}

std::string CheckJson(const Recording& recording, const RecordingCheck& check) {
  Json missing = Json::array();
  for (const MissingData& lack : recording.missing)
    missing.push_back({{"what", lack.what}, {"reason", lack.reason}, {"cost", lack.cost}});
  Json vertical = nullptr;
  if (check.vertical) {
    vertical = {{"count", check.vertical->count},
                {"slope", check.vertical->slope},
                {"correlation", check.vertical->correlation}};
  }
  const Json all = {{"name", recording.name},
                    {"dvl", check.dvl ? JsonOf(*check.dvl) : Json(nullptr)},
                    {"depth", check.depth ? JsonOf(*check.depth) : Json(nullptr)},
                    {"own_navigation", check.own ? JsonOf(*check.own) : Json(nullptr)},
                    {"vertical", vertical},
                    {"missing", missing},
                    {"left_out", recording.left_out},
                    {"doubts", recording.doubts}};
  return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace limpet
