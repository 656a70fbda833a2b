// SPDX-License-Identifier: MIT
// What pNav believes about the vehicle and about objects.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/frames.hpp"
#include "limpet/topics/sensors.hpp"
#include "limpet/topics/topic.hpp"

namespace limpet {

/// The estimate as known now. NED, body FRD; 1-sigma of each.
struct NavState {
  double north = 0.0, east = 0.0, down = 0.0;
  double roll = 0.0, pitch = 0.0, yaw = 0.0;
  double u = 0.0, v = 0.0, w = 0.0;  ///< body velocity over ground [m/s]
  double yaw_rate = 0.0;             ///< [rad/s]
  /// Of the body origin above the seabed [m], as `down` is its depth: their sum is the seabed's
  /// depth. Absent without bottom lock.
  std::optional<double> altitude;
  double sd_north = 0.0, sd_east = 0.0, sd_down = 0.0, sd_yaw = 0.0;

  template <class V>
  void Describe(V& visit) {
    visit("north", north), visit("east", east), visit("down", down);
    visit("roll", roll), visit("pitch", pitch), visit("yaw", yaw);
    visit("u", u), visit("v", v), visit("w", w), visit("yaw_rate", yaw_rate);
    visit("altitude", altitude);
    visit("sd_north", sd_north), visit("sd_east", sd_east), visit("sd_down", sd_down),
        visit("sd_yaw", sd_yaw);
  }
  [[nodiscard]] Pose pose() const { return {{north, east, down}, roll, pitch, yaw}; }
};

/// Position by integrating the DVL alone from the first GPS fix, for comparison.
struct DeadReckoning {
  double north = 0.0, east = 0.0, down = 0.0, yaw = 0.0;
  template <class V>
  void Describe(V& visit) {
    visit("north", north), visit("east", east), visit("down", down), visit("yaw", yaw);
  }
};

/// An object as the smoother knows it.
struct Landmark {
  int id = 0;
  std::array<double, 3> ned{};
  std::array<double, 6>
      cov{};  ///< upper triangle of the NED covariance [m^2]: nn, ne, nd, ee, ed, dd
  std::string color;
  int looks = 0;              ///< detections associated
  bool is_confirmed = false;  ///< enough looks and parallax to be an object; tentative ones are not
                              ///< published to users
  int prior_id = -1;          ///< object of the former session it was matched with, or -1
};
struct Landmarks {
  std::vector<Landmark> landmarks;
};
template <>
struct TopicCodec<Landmarks> : JsonCodec<Landmarks> {};

/// A box with the landmark it was associated with, or -1.
struct SightedBox {
  Box box;
  int landmark = -1;
};

/// One camera frame with the pose at its exposure: all the map needs.
struct Sight {
  int frame = 0;
  Seconds exposure;
  std::array<double, 3> ned{};  ///< of the body
  double roll = 0.0, pitch = 0.0, yaw = 0.0;
  std::optional<double> altitude;  ///< of the body origin above the seabed [m]
  std::vector<SightedBox> boxes;
  [[nodiscard]] Pose pose() const { return {{ned[0], ned[1], ned[2]}, roll, pitch, yaw}; }
};
template <>
struct TopicCodec<Sight> : JsonCodec<Sight> {};

/// DVL beams with the pose of the DVL at their time: NED of its lever arm, attitude of the body.
struct PosedBeams {
  double north = 0.0, east = 0.0, down = 0.0;
  double roll = 0.0, pitch = 0.0, yaw = 0.0;
  std::optional<double> b1, b2, b3, b4;
  template <class V>
  void Describe(V& visit) {
    visit("north", north), visit("east", east), visit("down", down);
    visit("roll", roll), visit("pitch", pitch), visit("yaw", yaw);
    visit("b1", b1), visit("b2", b2), visit("b3", b3), visit("b4", b4);
  }
  [[nodiscard]] Pose pose() const { return {{north, east, down}, roll, pitch, yaw}; }
};

namespace topics {
inline const Topic<double> kNavX{"NAV_X", "east of the datum [m]"};
inline const Topic<double> kNavY{"NAV_Y", "north of the datum [m]"};
inline const Topic<double> kNavHeading{"NAV_HEADING",
                                       "degrees clockwise from true north, [0, 360)"};
inline const Topic<double> kNavSpeed{"NAV_SPEED", "horizontal speed over ground [m/s]"};
inline const Topic<double> kNavDepth{"NAV_DEPTH", "depth [m], positive down"};
inline const Topic<double> kNavAltitude{"NAV_ALTITUDE", "body origin above the seabed [m]"};
inline const Topic<double> kNavYaw{"NAV_YAW", "radians counter-clockwise from east"};
inline const Topic<double> kNavPitch{"NAV_PITCH", "radians, nose up positive"};
inline const Topic<double> kNavRoll{"NAV_ROLL", "radians, starboard down positive"};
inline const Topic<NavState> kNavState{"NAV_STATE", "full estimate in NED, 10 Hz"};
inline const Topic<DeadReckoning> kNavDeadReckoning{"NAV_DEAD_RECKONING",
                                                    "DVL dead reckoning beside the estimate"};
inline const Topic<Landmarks> kNavLandmarks{"NAV_LANDMARKS",
                                            "objects with covariance, on change, at most 2 Hz"};
inline const Topic<Sight> kNavSight{"NAV_SIGHT", "each camera frame, posed and associated"};
inline const Topic<PosedBeams> kNavBeams{"NAV_BEAMS", "each DVL ping with the pose of the DVL"};
}  // namespace topics

}  // namespace limpet
