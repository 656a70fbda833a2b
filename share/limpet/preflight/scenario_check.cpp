// SPDX-License-Identifier: MIT
// What scenario.yaml says and no run of this mission would show: a world that is tamer than its
// author believes proves less than she thinks.
#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "limpet/core/key_section.hpp"
#include "limpet/preflight/checks.hpp"

namespace limpet::internal {
namespace {

/// A key that counts only where another one of its section has another value than its default.
struct Dependence {
  std::string_view key, on;
};
constexpr std::array kDependences{
    Dependence{"tide_swing_deg", "tide_period_s"},
    Dependence{"tide_share", "tide_period_s"},
    Dependence{"unrest_s", "unrest_share"},
    Dependence{"sway_period_s", "sway_m"},
    Dependence{"height_m", "shape"},
    Dependence{"heading_deg", "shape"},
    Dependence{"tilt_deg", "shape"},
    Dependence{"drift_time_s", "drift_deg_per_h"},
    Dependence{"late_s", "late_share"},
    Dependence{"walk_time_s", "walk_m"},
    Dependence{"jump_m", "jumps_per_h"},
    Dependence{"jump_shortest_s", "jumps_per_h"},
    Dependence{"jump_longest_s", "jumps_per_h"},
    Dependence{"false_velocity_shortest_s", "false_velocity_per_h"},
    Dependence{"false_velocity_longest_s", "false_velocity_per_h"},
    Dependence{"false_velocity_least_mps", "false_velocity_per_h"},
    Dependence{"false_velocity_most_mps", "false_velocity_per_h"},
};

/// Keys of the water that are shares of the mean current, or turn it.
constexpr std::array kOfTheCurrent{"tide_period_s", "tide_swing_deg", "tide_share",
                                   "unrest_share",  "shear_per_m",    "turn_deg_per_m"};

/// A section of the scenario as it is, and as it would be without a word in the file.
struct SaidSection {
  std::string path;  ///< as in the file, e.g. `errors.camera`
  std::vector<ParamSpec> said, unsaid;

  /// Those with other values than the defaults.
  [[nodiscard]] std::vector<ParamSpec> Others() const {
    std::vector<ParamSpec> others;
    for (std::size_t i = 0; i < said.size(); ++i) {
      if (said[i].default_text != unsaid[i].default_text) others.push_back(said[i]);
    }
    return others;
  }
  /// A key's default; empty if the section has no such key.
  [[nodiscard]] std::string DefaultOf(std::string_view key) const {
    const auto spec = std::ranges::find(unsaid, key, &ParamSpec::name);
    return spec == unsaid.end() ? "" : spec->default_text;
  }
};

/// Described, a struct tells its values as the defaults of its keys. Nothing is stored by them:
/// what they would store into is gone.
template <class Params>
SaidSection Said(std::string path, Params params) {
  Params unsaid{};
  return {std::move(path), DescribeParams(params), DescribeParams(unsaid)};
}

template <class SectionsOf, class Params>
void AddSections(const std::string& name, const SectionsOf& sections_of, Params params,
                 std::vector<SaidSection>& all) {
  Params unsaid{};
  std::vector<KeySection> said = sections_of(params), plain = sections_of(unsaid);
  for (std::size_t i = 0; i < said.size(); ++i) {
    all.push_back({said[i].name.empty() ? name : name + "." + said[i].name, said[i].keys,
                   std::move(plain[i].keys)});
  }
}

std::vector<SaidSection> SectionsOf(const Scenario& scenario) {
  std::vector<SaidSection> all{Said("water", scenario.water.current)};
  for (std::size_t i = 0; i < scenario.opis.size(); ++i) {
    all.push_back(Said(fmt::format("opis[{}]", i), scenario.opis[i].shape));
    all.push_back(Said(fmt::format("opis[{}]", i), scenario.opis[i].motion));
  }
  AddSections("errors", ErrorSections, scenario.errors, all);
  AddSections("image", ImageSections, scenario.image, all);
  return all;
}

/// Why nothing of a section shows; empty: it does.
std::string WhyIdle(const std::string& path, const MissionReading& reading) {
  const Scenario& scenario = *reading.scenario();
  if (path == "image" || path.starts_with("image.")) {
    const auto camera = reading.Find("uSimCamera", "camera");
    const bool is_own = !camera || camera->text == "scenario";
    if ((is_own ? scenario.camera : camera->text) == "boxes")
      return "a camera of boxes renders no pictures";
    if (path != "image" && scenario.image.look == "plain")
      return "it shows only with `image: {look: real}`";
  }
  if (path == "errors.fog" && reading.vehicle() && !reading.vehicle()->sensors.fog.is_present)
    return "the vehicle has no fibre-optic gyro";
  if (path == "errors.battery" && reading.vehicle() && !reading.vehicle()->battery.is_present)
    return "the vehicle has no battery";
  return "";
}

/// Why a key does not show although its section does; empty: it does.
std::string WhyIdle(const SaidSection& section, const std::string& key,
                    const std::vector<ParamSpec>& others, const Scenario::Water& water) {
  const bool is_still = water.current_north_mps == 0.0 && water.current_east_mps == 0.0;
  if (section.path == "water" && is_still && std::ranges::count(kOfTheCurrent, key) > 0)
    return "the mean current is 0";
  const auto* dependence = std::ranges::find(kDependences, key, &Dependence::key);
  if (dependence == kDependences.end() ||
      std::ranges::count(others, dependence->on, &ParamSpec::name) > 0) {
    return "";
  }
  const std::string idle = section.DefaultOf(dependence->on);
  return idle.empty() ? "" : fmt::format("{} is {}", dependence->on, idle);
}

void NoteSection(const SaidSection& section, const MissionReading& reading,
                 MissionProblems& found) {
  const std::vector<ParamSpec> others = section.Others();
  const std::string whole = WhyIdle(section.path, reading);
  for (const ParamSpec& key : others) {
    const std::string why =
        whole.empty() ? WhyIdle(section, key.name, others, reading.scenario()->water) : whole;
    if (why.empty()) continue;
    found.notes.push_back({reading.InScenario(section.path, key.name + ":"),
                           section.path + "." + key.name,
                           fmt::format("`{}` is without effect: {}", key.default_text, why)});
  }
}

/// Faults of sensors that the vehicle does not have.
void NoteFaults(const MissionReading& reading, MissionProblems& found) {
  const SensorSheets& sensors = reading.vehicle()->sensors;
  for (const ScenarioFault& fault : reading.scenario()->faults) {
    const bool is_of_fog = fault.what.starts_with("fog_") && !sensors.fog.is_present;
    const bool is_of_sonar = fault.what.starts_with("sonar_") && !sensors.sonar.is_present;
    if (!is_of_fog && !is_of_sonar) continue;
    found.notes.push_back({reading.InScenario("faults", fault.what), "faults",
                           fmt::format("`{}` is without effect: the vehicle has no {}", fault.what,
                                       is_of_fog ? "fibre-optic gyro" : "obstacle sonar")});
  }
}

}  // namespace

void CheckScenario(const MissionReading& reading, MissionProblems& found) {
  if (!reading.scenario()) return;
  for (const SaidSection& section : SectionsOf(*reading.scenario()))
    NoteSection(section, reading, found);
  if (reading.vehicle()) NoteFaults(reading, found);
}

}  // namespace limpet::internal
