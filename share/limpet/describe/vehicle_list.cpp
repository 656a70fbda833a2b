// SPDX-License-Identifier: MIT
#include "limpet/describe/vehicle_list.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limpet/describe/markdown_cell.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

namespace limpet {
namespace {

constexpr const char* kVehiclePageHead = R"(# The vehicle's file

Which vehicle flies a mission is said once, by the mission's global `VehicleFile = feelhippo.yaml`. The file is looked for beside the mission, then in `share/vehicles`, where those that come with Limpet are: `feelhippo.yaml` and `bluerov2.yaml`. pPilot flies by it and uSimVehicle simulates it; uSimSensors takes the antenna's place from it. Nothing else knows the vehicle's body. A mission that starts one of these, pNav or uSimCamera without the global is refused; keys that are unknown, given twice or out of range are refused with file, line and what is allowed.

A new vehicle: copy the file that is nearer to it beside your mission, weigh and measure it, and fly `limpet survey` with it before the vehicle does. Lengths are in metres from the centre of buoyancy, axes forward, starboard, down.

`name` is the vehicle's name. `thrusters.list` has an entry per thruster, six of them, each `{name: ..., at_m: [forward, starboard, down], push: [forward, starboard, down]}`: where it stands and which way it pushes the vehicle at a positive command, in the order of `THRUSTER_COMMAND`. Together they must push the vehicle ahead, aside and down and turn it; a pair of vertical thrusters one ahead of the other also pitches it, and without one pitch is left to buoyancy, as roll always is.

The other keys, from their declarations. What a file leaves out has the default. Generated: `limpet describe vehicle --markdown > docs/vehicle-file.md`.
)";

/// Of the file's defaults.
std::vector<VehicleFileSection> Sections() {
  static VehicleParams defaults;
  return VehicleFileSections(defaults);
}

std::string DefaultWithUnit(const ParamSpec& key) {
  return key.unit.empty() ? key.default_text : key.default_text + " " + key.unit;
}

}  // namespace

std::string VehicleKeysText() {
  std::string text;
  for (const VehicleFileSection& section : Sections()) {
    text += fmt::format("{}{}:\n", text.empty() ? "" : "\n", section.name);
    for (const ParamSpec& key : section.keys) {
      text += fmt::format("\n  {} = {}\n      {}\n      allowed: {}\n", key.name,
                          DefaultWithUnit(key), key.help, key.allowed);
    }
  }
  return text;
}

std::string VehicleKeysJson() {
  nlohmann::ordered_json sections = nlohmann::ordered_json::object();
  for (const VehicleFileSection& section : Sections()) {
    nlohmann::ordered_json& keys = sections[section.name] = nlohmann::ordered_json::array();
    for (const ParamSpec& key : section.keys) {
      keys.push_back({{"name", key.name},
                      {"unit", key.unit},
                      {"default", key.default_text},
                      {"allowed", key.allowed},
                      {"meaning", key.help}});
    }
  }
  return sections.dump(1) + "\n";
}

std::string VehicleKeysMarkdown() {
  std::string page = kVehiclePageHead;
  for (const VehicleFileSection& section : Sections()) {
    page +=
        fmt::format("\n## {}\n\n| key | default | allowed | meaning |\n| --- | --- | --- | --- |\n",
                    section.name);
    for (const ParamSpec& key : section.keys) {
      page += fmt::format("| `{}` | {} | {} | {} |\n", key.name, MarkdownCell(DefaultWithUnit(key)),
                          MarkdownCell(key.allowed), MarkdownCell(key.help));
    }
  }
  return page;
}

}  // namespace limpet
