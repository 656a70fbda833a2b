// SPDX-License-Identifier: MIT
// The water column: domain, seabed, dive.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/units.hpp"
#include "limpet/helm/motion_domain.hpp"
#include "limpet/preflight/checks.hpp"

namespace limpet::internal {
namespace {

MotionDomain DomainOf(const MissionReading& reading) {
  std::vector<ConfigEntry> lines;
  for (const Setting& line : reading.FindAll("pHelm", "domain")) {
    lines.push_back({line.key, line.text, line.where});
  }
  MotionDomain domain;
  static_cast<void>(ReadMotionDomain(lines, {}, domain));  // its problems are syntax
  return domain;
}

/// The `domain` line of one decision variable.
Setting DomainLine(const MissionReading& reading, std::string_view name) {
  for (const Setting& line : reading.FindAll("pHelm", "domain")) {
    if (Trim(Split(line.text, ':')[0]) == name) return line;
  }
  return {.owner = "pHelm", .key = "domain", .text = "", .unit = "", .where = {}};
}

struct Seabeds {
  double shallowest = 0.0, deepest = 0.0, at_start = 0.0;  ///< NED depth [m]
  double shallow_north = 0.0, shallow_east = 0.0;
};

/// Depths of the seabed's plane over the area and at the start; the relief, at three sigma, comes
/// on top.
Seabeds SeabedsOf(const Scenario& scenario, const SurveyArea& area) {
  const Scenario::Seabed& bed = scenario.seabed;
  const double slope = std::tan(RadiansFromDegrees(bed.slope_deg));
  const double toward = RadiansFromDegrees(bed.slope_toward_deg);
  const auto depth = [&](double north, double east) {
    return bed.depth_m + slope * (north * std::cos(toward) + east * std::sin(toward));
  };
  const double relief = 3.0 * bed.roughness_m;
  Seabeds seabeds{.shallowest = 1e9, .deepest = -1e9};
  const std::array<std::pair<double, double>, 5> places{
      std::pair{area.north_min, area.east_min},
      {area.north_min, area.east_max},
      {area.north_max, area.east_min},
      {area.north_max, area.east_max},
      {scenario.start.north_m, scenario.start.east_m}};
  for (const auto& [north, east] : places) {
    const double down = depth(north, east);
    seabeds.deepest = std::max(seabeds.deepest, down + relief);
    if (down - relief < seabeds.shallowest) {
      seabeds.shallowest = down - relief;
      seabeds.shallow_north = north;
      seabeds.shallow_east = east;
    }
  }
  seabeds.at_start = depth(scenario.start.north_m, scenario.start.east_m);
  return seabeds;
}

/// The altitude is held by beams that look down and ahead: so steep a seabed they take for a wall.
void CheckSlope(const MissionReading& reading, MissionProblems& found) {
  constexpr double kGood = 15.0, kMost = 30.0;  // [deg]
  const double slope = reading.scenario()->seabed.slope_deg;
  if (slope <= kGood) return;
  const SourceLine where = reading.InScenario("slope_deg:");
  if (slope > kMost) {
    found.geometry.push_back(
        {where, "seabed",
         fmt::format("slopes by {:g} degrees: the vehicle cannot hold its altitude over it; "
                     "allowed: up to {:g}, and surveys are good to {:g}",
                     slope, kMost, kGood)});
  } else {
    found.notes.push_back(
        {where, "seabed",
         fmt::format("slopes by {:g} degrees, and surveys are good to {:g}: altitude and view are "
                     "worse beyond",
                     slope, kGood)});
  }
}

void CheckDeep(const MissionReading& reading, const SurveyFacts& survey, const Seabeds& seabeds,
               MissionProblems& found) {
  const MotionDomain domain = DomainOf(reading);
  const double deepest = seabeds.deepest - survey.altitude.number();
  const Setting line = DomainLine(reading, "depth");
  if (domain.depth && deepest > domain.depth->high) {
    found.geometry.push_back(line.Refuse(fmt::format(
        "`{}`: the seabed is as deep as {:.1f} m, so that {} is {:.1f} m deep; allowed: a "
        "domain to {:.0f} m or more",
        line.text, seabeds.deepest, survey.altitude.Named(), deepest, std::ceil(deepest))));
  }
  CheckDepthLimit(reading, deepest, found);
  if (!reading.vehicle()) return;
  const double reach = reading.vehicle()->sensors.dvl.greatest_altitude.value();
  if (seabeds.at_start > reach) {
    found.geometry.push_back(
        {reading.InScenario("depth_m:"), "seabed",
         fmt::format("the seabed is {:.1f} m below the start, and the DVL reaches {:g} m: "
                     "BHV_HoldAltitude never gets an altitude to dive to",
                     seabeds.at_start, reach)});
  }
}

void CheckShallow(const MissionReading& reading, const SurveyFacts& survey, const Seabeds& seabeds,
                  MissionProblems& found) {
  const bool is_flat = reading.scenario()->seabed.slope_deg == 0.0;
  const SourceLine where = reading.InScenario(is_flat ? "depth_m:" : "slope_deg:");
  const std::string place =
      fmt::format("north {:g}, east {:g}", seabeds.shallow_north, seabeds.shallow_east);
  if (seabeds.shallowest <= 0.0) {
    found.geometry.push_back(
        {where, "seabed",
         fmt::format("rises {:.1f} m above the surface at {}", -seabeds.shallowest, place)});
    return;
  }
  // Of the camera, no frames come from shallower than this.
  const auto least = reading.Find("uSimCamera", "least_depth_m");
  const double needed = survey.altitude.number() + (least ? least->number() : 0.0);
  if (seabeds.shallowest <= needed) {
    found.geometry.push_back(
        {where, "seabed",
         fmt::format("is {:.1f} m deep at {}, and {} needs more than {:g} m of water",
                     seabeds.shallowest, place, survey.altitude.Named(), needed)});
  }
}

void CheckDive(const MissionReading& reading, const SurveyFacts& survey, const Seabeds& seabeds,
               MissionProblems& found) {
  const auto dive = reading.Find("pPilot", "max_dive_speed_mps");
  const auto give_up = reading.Find("pSurvey", "give_up_s");
  if (!dive || !give_up) return;
  const double duration = (seabeds.at_start - survey.altitude.number()) / dive->number();
  if (duration > give_up->number()) {
    found.geometry.push_back(
        give_up->Refuse(fmt::format("the dive to {} takes {:.0f} s at {}; allowed: at least that",
                                    survey.altitude.Named(), duration, dive->Named())));
  }
}

/// One variable of the helm's domain.
struct DomainRange {
  const char* variable;
  const std::optional<MotionAxis>& axis;
};

/// What behaviors ask for must be in the domain, or the helm asks for something else.
void CheckDomainOf(const MissionReading& reading, const char* type, const char* key,
                   const DomainRange& range, MissionProblems& found) {
  for (const Setting& wanted : reading.OfBehaviors(type, key)) {
    if (!range.axis) {
      found.geometry.push_back(wanted.Refuse(
          fmt::format("the helm's domain has no {}: nobody would hear of it", range.variable)));
    } else if (wanted.number() < range.axis->low || wanted.number() > range.axis->high) {
      found.geometry.push_back(
          wanted.Refuse(fmt::format("`{}` is outside of the helm's {}; allowed: {:g} to {:g} {}",
                                    wanted.text, DomainLine(reading, range.variable).Named(),
                                    range.axis->low, range.axis->high, wanted.unit)));
    }
  }
}

}  // namespace

void CheckMotion(const MissionReading& reading, MissionProblems& found) {
  if (!reading.Launches("pHelm") || reading.StandsIn("pHelm")) return;
  const MotionDomain domain = DomainOf(reading);
  const auto speed = [&](const char* type) {
    CheckDomainOf(reading, type, "speed_mps", {"speed", domain.speed}, found);
  };
  speed("BHV_FollowPath");
  speed("BHV_HoldStation");
  CheckDomainOf(reading, "BHV_ConstantDepth", "depth", {"depth", domain.depth}, found);
  const std::vector<Setting> stations = reading.OfBehaviors("BHV_HoldStation", "speed_mps");
  const Setting line = DomainLine(reading, "speed");
  if (!stations.empty() && domain.speed->low > 0.0) {
    found.geometry.push_back(
        line.Refuse(fmt::format("`{}` has no 0 m/s, and {} (BHV_HoldStation) stops the vehicle",
                                line.text, stations.front().owner)));
  }
}

/// From the survey altitude the DVL must have bottom lock.
void CheckDvlReach(const MissionReading& reading, const SurveyFacts& survey,
                   MissionProblems& found) {
  if (!reading.vehicle() || !reading.Launches("pNav")) return;
  const DvlSheet& dvl = reading.vehicle()->sensors.dvl;
  const double altitude = survey.altitude.number() - dvl.p_BD.z();
  const auto refuse = [&](const char* key, Meters bound, const char* than) {
    found.geometry.push_back(
        {reading.InVehicle(key), key,
         fmt::format("`{:g}`: the DVL is {:g} m above the seabed at {}, where it has no bottom "
                     "lock; allowed: {} than that",
                     bound.value(), altitude, survey.altitude.Named(), than)});
  };
  if (dvl.least_altitude.value() >= altitude)
    refuse("dvl.least_altitude_m", dvl.least_altitude, "less");
  if (dvl.greatest_altitude.value() <= altitude) {
    refuse("dvl.greatest_altitude_m", dvl.greatest_altitude, "more");
  }
}

void CheckDepths(const MissionReading& reading, const SurveyFacts& survey, MissionProblems& found) {
  CheckDvlReach(reading, survey, found);
  const MotionDomain domain = DomainOf(reading);
  if (!domain.depth) {
    found.geometry.push_back(
        DomainLine(reading, "course")
            .Refuse("there is no line for depth: the vehicle would not dive to be surveyed from"));
  } else if (domain.depth->low > 0.0) {
    const Setting line = DomainLine(reading, "depth");
    found.geometry.push_back(line.Refuse(
        fmt::format("`{}` has no 0 m: the vehicle could not come up to the surface", line.text)));
  }
  if (!reading.scenario()) return;
  const Seabeds seabeds = SeabedsOf(*reading.scenario(), survey.area);
  CheckSlope(reading, found);
  CheckShallow(reading, survey, seabeds, found);
  CheckDeep(reading, survey, seabeds, found);
  CheckDive(reading, survey, seabeds, found);
}

}  // namespace limpet::internal
