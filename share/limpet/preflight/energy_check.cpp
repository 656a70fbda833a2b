// SPDX-License-Identifier: MIT
// Whether the battery lasts: there, around and back, with the reserve that is to be left at home.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limpet/energy/way_power.hpp"
#include "limpet/preflight/checks.hpp"

namespace limpet::internal {
namespace {

constexpr double kTightEnergy = 1.3;  // lanes overlap, and objects want second looks

/// Drawn on the way [W]: on lanes to and fro, and against what current there is.
struct CruisePowers {
  double to_and_fro_w = 0.0;
  double against_w = 0.0;
};

CruisePowers PowersOf(const VehicleParams& vehicle, const BatterySheet& battery, double speed_mps,
                      double current_mps) {
  const WayPower power(vehicle, battery);
  const auto at = [&power](double through_water_mps) {
    return power.Cruising(MetersPerSecond(std::abs(through_water_mps)));
  };
  const double against_w = at(speed_mps + current_mps);
  return {.to_and_fro_w = 0.5 * (against_w + at(speed_mps - current_mps)), .against_w = against_w};
}

/// The vehicle's battery with the errors that the scenario gives it.
BatterySheet BatteryOf(const MissionReading& reading) {
  BatterySheet battery = reading.vehicle()->battery;
  if (!reading.scenario()) return battery;
  const BatteryErrorParams& errors = reading.scenario()->errors.battery;
  battery.capacity_wh *= errors.capacity_factor;
  battery.hotel_w *= errors.hotel_factor;
  battery.full_thrust_w *= errors.thrust_power_factor;
  return battery;
}

/// Rule battery_low must not end a survey that the battery lasts for.
void CheckLowLimit(const MissionReading& reading, const EnergyOutlook& energy, double full_wh,
                   MissionProblems& found) {
  if (IsRuleOff(reading, "battery_low")) return;
  const Setting limit = *reading.Find("pSafety", "battery_low_percent");
  const double left_percent =
      100.0 * (energy.charged_wh - energy.needed_wh + energy.home_wh) / full_wh;
  if (limit.number() < left_percent) return;
  found.geometry.push_back(limit.Refuse(fmt::format(
      "`{}`: rule battery_low would end the survey: {:.0f} % are left when the way home "
      "begins; allowed: less than that",
      limit.text, std::max(0.0, left_percent))));
}

SourceLine WhereOf(const MissionReading& reading) {
  const SourceLine charge = reading.InScenario("battery:");
  return charge.line > 0 ? charge : reading.InVehicle("battery.capacity_wh");
}

}  // namespace

void CheckEnergy(const MissionReading& reading, const SurveyFacts& survey, const SessionWay& way,
                 MissionProblems& found) {
  if (!reading.vehicle() || !reading.vehicle()->battery.is_present) return;
  const BatterySheet battery = BatteryOf(reading);
  const double speed = survey.speed.number();
  const CruisePowers powers = PowersOf(reading.vehicle()->params, battery, speed, way.current_mps);
  if (!std::isfinite(powers.against_w)) return;  // it makes no way: that is said of the current
  const auto at_rest_j = [&](const char* wait) {
    return battery.hotel_w * reading.Find("pSurvey", wait)->number();
  };
  const double home_wh =
      (powers.against_w * way.home_m / speed + at_rest_j("last_fix_s")) / kJoulesPerWh;
  const double out_j = powers.to_and_fro_w * way.out_m / speed + at_rest_j("align_s");
  const double needed_wh = out_j / kJoulesPerWh + home_wh;
  const Setting reserve = reading.Find("pSurvey", "energy_reserve_percent").value();
  const double charge = reading.scenario() ? reading.scenario()->errors.battery.charge : 1.0;
  const double charged_wh = charge * battery.capacity_wh;
  const double usable_wh = charged_wh - 0.01 * reserve.number() * battery.capacity_wh;
  found.energy = EnergyOutlook{.needed_wh = needed_wh,
                               .home_wh = home_wh,
                               .charged_wh = charged_wh,
                               .reserve_wh = charged_wh - usable_wh};
  const std::string text = fmt::format(
      "the survey takes about {:.0f} Wh, {:.0f} Wh of them for the way home with the wait at the "
      "surface, at {}; "
      "the battery holds {:.0f} Wh, of which {} keeps {:.0f} Wh",
      needed_wh, home_wh, survey.speed.Named(), charged_wh, reserve.Named(),
      charged_wh - usable_wh);
  if (needed_wh > usable_wh) {
    found.geometry.push_back({WhereOf(reading), "battery",
                              text + fmt::format("; allowed: {:.0f} Wh or more",
                                                 std::ceil(needed_wh + charged_wh - usable_wh))});
  } else if (kTightEnergy * needed_wh > usable_wh) {
    found.notes.push_back({WhereOf(reading), "battery", "is tight: " + text});
  }
  if (needed_wh <= usable_wh) CheckLowLimit(reading, *found.energy, battery.capacity_wh, found);
}

}  // namespace limpet::internal
