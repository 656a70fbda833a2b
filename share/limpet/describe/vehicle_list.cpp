// SPDX-License-Identifier: MIT
#include "limpet/describe/vehicle_list.hpp"

#include <utility>
#include <vector>

#include "limpet/describe/key_sections.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

namespace limpet {
namespace {

constexpr const char* kVehiclePageHead = R"(# The vehicle's file

Which vehicle flies a mission is said once, by the mission's global `VehicleFile = feelhippo.yaml`. The file is looked for beside the mission, then in `share/vehicles`, where those that come with Limpet are: `feelhippo.yaml` and `bluerov2.yaml`. It is the vehicle's only description: hull, thrusters, sensors and camera. pPilot flies by it; uSimVehicle, uSimSensors and uSimCamera simulate it; pNav believes it; pHelm, pMap and pNav take the camera from it. A mission that starts one of these without the global is refused; keys that are unknown, given twice or out of range are refused with file, line and what is allowed.

A new vehicle: copy the file that is nearer to it beside your mission, weigh and measure it, and fly `limpet survey` with it before the vehicle does. Lengths are in metres from the centre of buoyancy, axes forward, starboard, down.

`name` is the vehicle's name. `thrusters.list` has an entry per thruster, four to eight of them, each `{name: ..., at_m: [forward, starboard, down], push: [forward, starboard, down]}`: where it stands and which way it pushes the vehicle at a positive command, in the order of `THRUSTER_COMMAND`. Together they must push the vehicle ahead, aside and down and turn it; a pair of vertical thrusters one ahead of the other also pitches it, and without one pitch is left to buoyancy, as roll always is. Each has its mirror image on the other side, unless it is its own: one that was left out is refused.

Sensors are described as their data sheets do. The simulator builds such sensors; where `scenario.yaml` says under `sensors` how large an error truly is (`heading_sigma_deg`, `yaw_bias_deg_per_h`, `gps_sigma_m`), it is that. pNav never hears of the scenario: it believes the sheets, with margins of its own (velocity 1.2, gyro bias 2, depth 1.4 times). A vehicle without a fibre-optic gyro (`fog: {present: false}`) turns by its IMU's yaw rate, which is believed less.

A file with a section `battery` has a battery: uSimVehicle drains it (hotel load, and what each thruster draws), its voltage sags, and `BATTERY` says what its gauge shows; capacity and gauge differ from the sheet by their sigmas, drawn from the seed, and by `errors.battery` of the scenario. On board the sheet is believed with a margin (0.85 of the capacity, 1.25 of what is drawn) until use has told (`ENERGY_STATE`). A file without it flies without: no `BATTERY`, and no rule of energy.

`based_on: feelhippo.yaml` gives everything that the file leaves out as another file has it.

What blocks of a mission used to say of the sensors is the file's to say: `camera_...` of pHelm, pMap, pNav and uSimCamera, `rate_hz` of uSimCamera, `heading_sigma_deg`, `dvl_x_m`, `dvl_y_m`, `dvl_z_m` and `top_speed_mps` of pNav, `platform_length` of pNodeReporter. The rule for all: a block that says what the file says flies as before, one that says something else is refused, with the file's key and line. `--set` overrides a parameter that a block still has.

The other keys, from their declarations. The camera's field of view and image have no default: blocks that need a camera are refused without them. What else a file leaves out has the default. Generated: `limpet describe vehicle --markdown > docs/vehicle-file.md`.
)";

/// Sections of the vehicle's file, with its defaults.
std::vector<KeySection> Sections() {
  static VehicleFile defaults;
  return VehicleFileSections(defaults);
}

}  // namespace

std::string VehicleKeysText() { return KeysText(Sections()); }
std::string VehicleKeysJson() { return KeysJson(Sections()); }
std::string VehicleKeysMarkdown() { return kVehiclePageHead + KeysMarkdown(Sections()); }

}  // namespace limpet
