// SPDX-License-Identifier: MIT
// SIM_*: the truth. Written by uSim apps; read by uSim apps and the scorer, by nothing on board.
#pragma once

#include <optional>

#include "limpet/core/frames.hpp"
#include "limpet/topics/topic.hpp"

namespace limpet {

/// True state of the vehicle. NED, body FRD; metres, radians, seconds.
struct SimTruth {
  double north = 0.0, east = 0.0, down = 0.0;
  double roll = 0.0, pitch = 0.0, yaw = 0.0;
  double u = 0.0, v = 0.0, w = 0.0;  ///< velocity over ground in the body frame [m/s]
  double p = 0.0, q = 0.0, r = 0.0;  ///< body rates [rad/s]
  double fx = 0.0, fy = 0.0,
         fz = 0.0;  ///< specific force in the body frame [m/s^2], what an accelerometer feels

  template <class V>
  void Describe(V& visit) {
    visit("north", north), visit("east", east), visit("down", down);
    visit("roll", roll), visit("pitch", pitch), visit("yaw", yaw);
    visit("u", u), visit("v", v), visit("w", w);
    visit("p", p), visit("q", q), visit("r", r);
    visit("fx", fx), visit("fy", fy), visit("fz", fz);
  }
  [[nodiscard]] Pose pose() const { return {{north, east, down}, roll, pitch, yaw}; }
};

/// What the thrusters are made to do, and how the driver's watchdog has fared.
struct SimThrust {
  double greatest = 0.0;          ///< thrust now in force, of the thruster that works hardest
  std::optional<double> zero_at;  ///< MOOS time at which all last went to zero; absent: never yet
  double oldest_obeyed = 0.0;     ///< greatest age that an obeyed command had [s]
  int stops = 0;                  ///< times that the command had become too old
  int refused = 0;                ///< commands refused: not finite, or beyond full thrust

  template <class V>
  void Describe(V& visit) {
    visit("greatest", greatest), visit("zero_at", zero_at);
    visit("oldest_obeyed", oldest_obeyed), visit("stops", stops), visit("refused", refused);
  }
};

/// The battery as it truly is, faults of its gauge aside.
struct SimBattery {
  double charge = 1.0;       ///< share of a full one
  double capacity_wh = 0.0;  ///< of a full one
  double used_wh = 0.0;      ///< since the simulator started
  bool is_off = false;       ///< its protection has switched it off

  template <class V>
  void Describe(V& visit) {
    visit("charge", charge), visit("capacity_wh", capacity_wh), visit("used_wh", used_wh);
    visit("is_off", is_off);
  }
};

namespace topics {
inline const auto kSimThrust = Declare<SimThrust>(
    "SIM_THRUST", "thrust in force, and what the thrusters' watchdog did",
    {.unit = "-1 to 1, s", .rate = "1 Hz and on change", .writers = {"uSimVehicle"}});
inline const auto kSimTruth = Declare<SimTruth>(
    "SIM_TRUTH", "true state of the vehicle",
    {.unit = "m, rad, s", .frame = "NED, body FRD", .rate = "50 Hz", .writers = {"uSimVehicle"}});
inline const auto kSimBattery = Declare<SimBattery>(
    "SIM_BATTERY", "the battery as it truly is",
    {.unit = "share, Wh", .rate = "1 Hz, where the vehicle has one", .writers = {"uSimVehicle"}});
inline const auto kSimEvent =
    Declare<std::string>("SIM_EVENT", "surfaced, submerged, touched_bottom, left_bottom",
                         {.rate = "on event", .writers = {"uSimVehicle"}});
}  // namespace topics

}  // namespace limpet
