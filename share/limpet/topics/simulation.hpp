// SPDX-License-Identifier: MIT
// SIM_*: the truth. Written by uSim apps; read by uSim apps and the scorer, by nothing on board.
#pragma once

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

namespace topics {
inline const auto kSimTruth = Declare<SimTruth>(
    "SIM_TRUTH", "true state of the vehicle",
    {.unit = "m, rad, s", .frame = "NED, body FRD", .rate = "50 Hz", .writers = {"uSimVehicle"}});
inline const auto kSimEvent =
    Declare<std::string>("SIM_EVENT", "surfaced, submerged, touched_bottom, left_bottom",
                         {.rate = "on event", .writers = {"uSimVehicle"}});
}  // namespace topics

}  // namespace limpet
