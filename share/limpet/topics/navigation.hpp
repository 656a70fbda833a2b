// SPDX-License-Identifier: MIT
// What pNav believes about the vehicle and about objects.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/frames.hpp"
#include "limpet/objects/frame.hpp"
#include "limpet/objects/object_estimate.hpp"
#include "limpet/topics/sensors.hpp"
#include "limpet/topics/topic.hpp"

namespace limpet {

/// What one sensor gives the estimate.
struct NavSource {
  /// Seconds of vehicle time since its last good sample was measured; absent before the first.
  std::optional<double> age = std::nullopt;
  /// That is no longer than pNav waits for one. Absent: the writer does not say.
  std::optional<bool> is_valid = std::nullopt;
  /// Share of its samples of the last ten seconds or so that were refused as outliers. Absent: the
  /// writer does not say.
  std::optional<double> refused = std::nullopt;
};

/// The estimate as known now. NED, body FRD; 1-sigma of each. While sensors are silent the sigmas
/// grow by what the vehicle and the water can do meanwhile.
struct NavState {
  double north = 0.0, east = 0.0, down = 0.0;
  double roll = 0.0, pitch = 0.0, yaw = 0.0;
  double u = 0.0, v = 0.0, w = 0.0;  ///< body velocity over ground [m/s]
  /// Seconds since the DVL last gave a velocity; absent while it does. In such a dropout u and v
  /// are what the vehicle was last seen to do in the water, no feedback of what it does, and the
  /// estimated current; w comes from the depth sensor.
  std::optional<double> velocity_age = std::nullopt;
  double yaw_rate = 0.0;  ///< [rad/s]
  /// Height of the body origin above the seabed [m], as `down` is its depth: their sum is the
  /// seabed's depth. Absent without bottom lock, but for a vehicle with an echo sounder.
  std::optional<double> altitude;
  double sd_north = 0.0, sd_east = 0.0, sd_down = 0.0, sd_yaw = 0.0;
  /// False: nothing has told pNav lately how the vehicle moves (no attitude, or neither bottom
  /// track nor depth nor a fix). Position and attitude are then where they were last known, and
  /// NAV_X and its kin are silent. Absent, from another writer, counts as true.
  std::optional<bool> is_valid = std::nullopt;
  /// `dvl`: velocity over ground; `fog`: without it the IMU's own yaw rate serves; under water
  /// there is no GPS, and `camera` counts frames, also of nothing. IMU and DVL say what they
  /// refuse.
  NavSource imu = {}, fog = {}, dvl = {}, depth = {}, gps = {}, camera = {};

  template <class V>
  void Describe(V& visit) {
    visit("north", north), visit("east", east), visit("down", down);
    visit("roll", roll), visit("pitch", pitch), visit("yaw", yaw);
    visit("u", u), visit("v", v), visit("w", w), visit("yaw_rate", yaw_rate);
    visit("altitude", altitude), visit("velocity_age", velocity_age);
    visit("sd_north", sd_north), visit("sd_east", sd_east), visit("sd_down", sd_down),
        visit("sd_yaw", sd_yaw);
    visit("is_valid", is_valid);
    visit("imu_age", imu.age), visit("imu_valid", imu.is_valid);
    visit("imu_refused", imu.refused);
    visit("fog_age", fog.age), visit("fog_valid", fog.is_valid);
    visit("dvl_age", dvl.age), visit("dvl_valid", dvl.is_valid);
    visit("dvl_refused", dvl.refused);
    visit("depth_age", depth.age), visit("depth_valid", depth.is_valid);
    visit("gps_age", gps.age), visit("gps_valid", gps.is_valid);
    visit("camera_age", camera.age), visit("camera_valid", camera.is_valid);
  }
  [[nodiscard]] Pose pose() const { return {{north, east, down}, roll, pitch, yaw}; }
  /// The vehicle may be steered by it.
  [[nodiscard]] bool is_usable() const { return is_valid.value_or(true); }
};

/// Position by integrating the DVL alone from the first GPS fix, for comparison.
struct DeadReckoning {
  double north = 0.0, east = 0.0, down = 0.0, yaw = 0.0;
  template <class V>
  void Describe(V& visit) {
    visit("north", north), visit("east", east), visit("down", down), visit("yaw", yaw);
  }
};

/// Motion of the water, as estimated from the bottom track; where it comes to, north and east.
struct WaterCurrent {
  double north = 0.0, east = 0.0;  ///< [m/s]
  double sd = 0.0;                 ///< 1-sigma of each [m/s]
  template <class V>
  void Describe(V& visit) {
    visit("north", north), visit("east", east), visit("sd", sd);
  }
};

struct Landmarks {
  std::vector<Landmark> landmarks;
};
template <>
struct TopicCodec<Landmarks> : JsonCodec<Landmarks> {};

/// Joint covariance of landmarks' places, which NAV_LANDMARKS has, in the frame of their session.
struct LandmarkCovariance {
  std::vector<int> ids;
  Eigen::MatrixXd cov_W;  ///< NED [m^2], three rows per landmark in the order of `ids`
};
template <>
struct TopicCodec<LandmarkCovariance> : JsonCodec<LandmarkCovariance> {};

template <>
struct TopicCodec<ObservedFrame> : JsonCodec<ObservedFrame> {};

/// How the smoother moved the way already travelled since it last said so: after a fix that ends a
/// dive, or a loop closed. Landmarks move with it; so must whoever keeps poses of NAV_CAMERA_FRAME.
struct TrackShift {
  /// MOOS time, and the shift of north, east, down [m] and yaw [rad] then; linear in between.
  std::vector<std::array<double, 5>> steps;
  /// MOOS time, and how sure the place is known since, as PlaceSigma has it: absolute, beside [m];
  /// linear in between. Empty: nobody says.
  std::vector<std::array<double, 3>> sigmas = {};
  /// How sure the place of time `t` is now; nothing where that is not said.
  [[nodiscard]] std::optional<PlaceSigma> SigmaAt(double t) const;
  /// A pose kept from time `t`, moved along; later ones than the last step stay as they are.
  [[nodiscard]] Pose Apply(double t, const Pose& X_WB) const;
};
template <>
struct TopicCodec<TrackShift> : JsonCodec<TrackShift> {};

/// DVL beams with the pose of the DVL at their time: NED of its lever arm, attitude of the body.
struct PosedBeams {
  double north = 0.0, east = 0.0, down = 0.0;
  double roll = 0.0, pitch = 0.0, yaw = 0.0;
  std::optional<double> b1, b2, b3, b4;
  std::optional<double> sd_down;  ///< of the pose's depth, 1-sigma [m]
  template <class V>
  void Describe(V& visit) {
    visit("north", north), visit("east", east), visit("down", down);
    visit("roll", roll), visit("pitch", pitch), visit("yaw", yaw);
    visit("b1", b1), visit("b2", b2), visit("b3", b3), visit("b4", b4);
    visit("sd_down", sd_down);
  }
  [[nodiscard]] Pose pose() const { return {{north, east, down}, roll, pitch, yaw}; }
};

/// A sonar's ping with the pose of the sonar at its time: NED, attitude of the body.
struct PosedSonar {
  double north = 0.0, east = 0.0, down = 0.0;
  double roll = 0.0, pitch = 0.0, yaw = 0.0;
  SonarPing ping;
  [[nodiscard]] Pose pose() const { return {{north, east, down}, roll, pitch, yaw}; }
};
template <>
struct TopicCodec<PosedSonar> : JsonCodec<PosedSonar> {};

namespace topics {
inline const auto kNavX = Declare<double>(
    "NAV_X", "position; silent, like all of NAV_ but NAV_STATE, while that is not valid",
    {.unit = "m", .frame = "east of the datum", .rate = "10 Hz", .writers = {"pNav"}});
inline const auto kNavY = Declare<double>(
    "NAV_Y", "position",
    {.unit = "m", .frame = "north of the datum", .rate = "10 Hz", .writers = {"pNav"}});
inline const auto kNavHeading = Declare<double>(
    "NAV_HEADING", "heading, 0 to below 360",
    {.unit = "deg", .frame = "clockwise from true north", .rate = "10 Hz", .writers = {"pNav"}});
inline const auto kNavSpeed =
    Declare<double>("NAV_SPEED", "horizontal speed",
                    {.unit = "m/s", .frame = "over ground", .rate = "10 Hz", .writers = {"pNav"}});
inline const auto kNavDepth = Declare<double>(
    "NAV_DEPTH", "depth",
    {.unit = "m", .frame = "down from the surface", .rate = "10 Hz", .writers = {"pNav"}});
inline const auto kNavAltitude = Declare<double>(
    "NAV_ALTITUDE", "body origin above the seabed; silent without bottom lock",
    {.unit = "m", .frame = "up from the seabed", .rate = "10 Hz", .writers = {"pNav"}});
inline const auto kNavYaw = Declare<double>(
    "NAV_YAW", "heading",
    {.unit = "rad", .frame = "counter-clockwise from east", .rate = "10 Hz", .writers = {"pNav"}});
inline const auto kNavPitch = Declare<double>(
    "NAV_PITCH", "pitch",
    {.unit = "rad", .frame = "nose up positive", .rate = "10 Hz", .writers = {"pNav"}});
inline const auto kNavRoll = Declare<double>(
    "NAV_ROLL", "roll",
    {.unit = "rad", .frame = "starboard down positive", .rate = "10 Hz", .writers = {"pNav"}});
inline const auto kNavState = Declare<NavState>(
    "NAV_STATE", "full estimate with its 1-sigma, age and validity of each sensor's samples",
    {.unit = "m, rad, s", .frame = "NED, body FRD", .rate = "10 Hz", .writers = {"pNav"}});
inline const auto kNavDeadReckoning = Declare<DeadReckoning>(
    "NAV_DEAD_RECKONING", "DVL dead reckoning from the first GPS fix, for comparison",
    {.unit = "m, rad", .frame = "NED", .rate = "10 Hz", .writers = {"pNav"}});
inline const auto kNavCurrent = Declare<WaterCurrent>(
    "NAV_CURRENT",
    "current, where it sets to, with its 1-sigma: large until bottom track and turns have told",
    {.unit = "m/s", .frame = "NED", .rate = "1 Hz", .writers = {"pNav"}});
inline const auto kNavLandmarks = Declare<Landmarks>(
    "NAV_LANDMARKS", "objects with covariance, and which of the former session's each one is",
    {.unit = "m", .frame = "NED", .rate = "on change, at most 2 Hz", .writers = {"pNav"}});
inline const auto kNavLandmarkJoint = Declare<LandmarkCovariance>(
    "NAV_LANDMARK_JOINT", "joint covariance of all objects, for the saved session",
    {.unit = "m", .frame = "NED", .rate = "on MAP_SNAPSHOT_REQUEST", .writers = {"pNav"}});
inline const auto kNavCameraFrame = Declare<ObservedFrame>(
    "NAV_CAMERA_FRAME", "each camera frame, posed and associated",
    {.unit = "m, rad, px", .frame = "NED, body FRD, image", .rate = "4 Hz", .writers = {"pNav"}});
inline const auto kNavTrackShift = Declare<TrackShift>(
    "NAV_TRACK_SHIFT",
    "how the way behind moved, and how sure it is now; just before NAV_LANDMARKS that moved along",
    {.unit = "m, rad, s", .frame = "NED", .rate = "on change, at most 2 Hz", .writers = {"pNav"}});
inline const auto kNavBeams = Declare<PosedBeams>(
    "NAV_BEAMS", "each DVL ping with the pose of the DVL",
    {.unit = "m, rad", .frame = "NED, body FRD", .rate = "5 Hz", .writers = {"pNav"}});
inline const auto kNavSonar = Declare<PosedSonar>(
    "NAV_SONAR", "each ping of the sonar that looks ahead, with its pose",
    {.unit = "m, rad", .frame = "NED, body FRD", .rate = "4 Hz", .writers = {"pNav"}});
}  // namespace topics

}  // namespace limpet
