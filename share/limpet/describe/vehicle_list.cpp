// SPDX-License-Identifier: MIT
#include "limpet/describe/vehicle_list.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limpet/describe/markdown_cell.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

namespace limpet {
namespace {

constexpr const char* kVehiclePageHead = R"(# The vehicle's file

Which vehicle flies a mission is said once, by the mission's global `VehicleFile = feelhippo.yaml`. The file is looked for beside the mission, then in `share/vehicles`, where those that come with Limpet are: `feelhippo.yaml` and `bluerov2.yaml`. It is the vehicle's only description: hull, thrusters, sensors and camera. pPilot flies by it; uSimVehicle, uSimSensors and uSimCamera simulate it; pNav believes it; pHelm, pMap and pNav take the camera from it. A mission that starts one of these without the global is refused; keys that are unknown, given twice or out of range are refused with file, line and what is allowed.

A new vehicle: copy the file that is nearer to it beside your mission, weigh and measure it, and fly `limpet survey` with it before the vehicle does. Lengths are in metres from the centre of buoyancy, axes forward, starboard, down.

`name` is the vehicle's name. `thrusters.list` has an entry per thruster, six of them, each `{name: ..., at_m: [forward, starboard, down], push: [forward, starboard, down]}`: where it stands and which way it pushes the vehicle at a positive command, in the order of `THRUSTER_COMMAND`. Together they must push the vehicle ahead, aside and down and turn it; a pair of vertical thrusters one ahead of the other also pitches it, and without one pitch is left to buoyancy, as roll always is.

Sensors are described as their data sheets do. The simulator builds such sensors; where `scenario.yaml` says under `sensors` how large an error truly is (`heading_sigma_deg`, `yaw_bias_deg_per_h`, `gps_sigma_m`), it is that. pNav never hears of the scenario: it believes the sheets, with margins of its own (velocity 1.2, gyro bias 2, depth 1.4 times). A vehicle without a fibre-optic gyro (`fog: {present: false}`) turns by its IMU's yaw rate, which is believed less.

`based_on: feelhippo.yaml` gives everything that the file leaves out as another file has it.

What blocks of a mission used to say of the sensors is the file's to say: `camera_...` of pHelm, pMap, pNav and uSimCamera, `rate_hz` of uSimCamera, `heading_sigma_deg`, `dvl_x_m`, `dvl_y_m` and `dvl_z_m` of pNav. The rule for all: a block that says what the file says flies as before, one that says something else is refused, with the file's key and line. `--set` overrides a parameter that a block still has.

The other keys, from their declarations. The camera's field of view and image have no default: blocks that need a camera are refused without them. What else a file leaves out has the default. Generated: `limpet describe vehicle --markdown > docs/vehicle-file.md`.
)";

/// Of the file's defaults.
std::vector<VehicleFileSection> Sections() {
  static VehicleFile defaults;
  return VehicleFileSections(defaults);
}

std::string DefaultWithUnit(const ParamSpec& key) {
  if (key.is_required) return "required";
  return key.unit.empty() ? key.default_text : key.default_text + " " + key.unit;
}

}  // namespace

std::string VehicleKeysText() {
  std::string text;
  for (const VehicleFileSection& section : Sections()) {
    text += fmt::format("{}{}:\n", text.empty() ? "" : "\n", section.name);
    for (const ParamSpec& key : section.keys) {
      text +=
          fmt::format("\n  {}{}{}\n      {}\n      allowed: {}\n", key.name,
                      key.is_required ? ": " : " = ", DefaultWithUnit(key), key.help, key.allowed);
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
