// SPDX-License-Identifier: MIT
// What the vehicle's sensors say. On a real vehicle its drivers write these; in simulation
// uSimSensors and uSimCamera.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/message.hpp"
#include "limpet/objects/frame.hpp"
#include "limpet/topics/topic.hpp"

namespace limpet {

/// Accelerometer, gyro and magnetic heading, body FRD.
struct ImuSample {
  double fx = 0.0, fy = 0.0, fz = 0.0;  ///< specific force [m/s^2]; (0, 0, -9.81) at rest and level
  double p = 0.0, q = 0.0, r = 0.0;     ///< rates [rad/s]
  double heading =
      0.0;  ///< magnetic heading corrected to true north [rad]; absolute, error nearly constant

  template <class V>
  void Describe(V& visit) {
    visit("fx", fx), visit("fy", fy), visit("fz", fz);
    visit("p", p), visit("q", q), visit("r", r), visit("heading", heading);
  }
};

/// Bottom-track velocity at the DVL's lever arm in body axes [m/s], its 1-sigma, vertical altitude
/// of the DVL itself (not of the body origin) [m] and slant ranges [m] of four beams 25 deg from
/// vertical at azimuth 45, 135, 225, 315 deg. Absent: not measured.
struct DvlSample {
  bool has_lock = false;
  std::optional<double> u, v, w;
  std::optional<double> altitude;
  std::optional<double> b1, b2, b3, b4;
  double sd_horizontal = 0.01, sd_vertical = 0.005;

  template <class V>
  void Describe(V& visit) {
    visit("has_lock", has_lock);
    visit("u", u), visit("v", v), visit("w", w), visit("altitude", altitude);
    visit("b1", b1), visit("b2", b2), visit("b3", b3), visit("b4", b4);
    visit("sd_horizontal", sd_horizontal), visit("sd_vertical", sd_vertical);
  }
  [[nodiscard]] std::array<std::optional<double>, 4> beams() const { return {b1, b2, b3, b4}; }
};

/// One ping of a sonar that looks ahead: how far the first echo of each beam comes from. Beams lie
/// level with the vehicle, from port to starboard.
struct SonarPing {
  double first = 0.0;          ///< bearing of the first beam, clockwise from ahead [rad]
  double step = 0.0;           ///< from beam to beam [rad]
  double reach = 0.0;          ///< echoes are heard up to here [m]
  std::vector<double> ranges;  ///< [m]; 0: no echo within reach
};
template <>
struct TopicCodec<SonarPing> : JsonCodec<SonarPing> {};

/// A fix at the surface in the mission's local frame [m]; the error is mostly correlated over
/// minutes.
struct GpsFix {
  double north = 0.0, east = 0.0, sd = 0.0;
  template <class V>
  void Describe(V& visit) {
    visit("north", north), visit("east", east), visit("sd", sd);
  }
};

/// A fix by an acoustic positioning system in the mission's local frame [m], of the body origin.
struct UsblFix {
  double north = 0.0, east = 0.0, down = 0.0, sd = 0.0;
  template <class V>
  void Describe(V& visit) {
    visit("north", north), visit("east", east), visit("down", down), visit("sd", sd);
  }
};

/// One image, 8-bit BGR, row-major, as exposed at `exposure` (MOOS time).
struct CameraFrame {
  std::uint32_t frame = 0;
  Seconds exposure;
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> bgr;  ///< width * height * 3 bytes
};
/// Header of 32 little-endian bytes (magic "LCF1", frame u32, exposure f64, width u32, height u32,
/// 8 reserved), pixels.
template <>
struct TopicCodec<CameraFrame> {
  [[nodiscard]] static Value Encode(const CameraFrame& frame);
  [[nodiscard]] static std::optional<CameraFrame> Decode(const Value& value);
};

/// How strongly the ground stands out in a picture: spread over mean, by channel, beyond what noise
/// alone would show. docs/water.md.
struct GroundContrast {
  double exposure = 0.0;  ///< MOOS time [s]
  double blue = 0.0, green = 0.0, red = 0.0;
  double noise = 0.0;  ///< what noise alone would show
  template <class V>
  void Describe(V& visit) {
    visit("exposure", exposure), visit("blue", blue), visit("green", green), visit("red", red);
    visit("noise", noise);
  }
};

/// Images are that far apart at least; ground does not change faster.
inline constexpr Seconds kContrastPeriod{1.0};

/// Sent for every frame, also when it shows nothing. Boxes have no `landmark` yet.
template <>
struct TopicCodec<Detections> : JsonCodec<Detections> {};

namespace topics {
inline const auto kImuData =
    Declare<ImuSample>("IMU_DATA", "accelerometer, gyro and magnetic heading",
                       {.unit = "m/s^2, rad/s, rad",
                        .frame = "body FRD",
                        .rate = "50 Hz",
                        .writers = {"uSimSensors"}});
inline const auto kFogYawRate = Declare<double>("FOG_YAW_RATE", "fibre-optic gyro",
                                                {.unit = "rad/s",
                                                 .frame = "body z, starboard positive",
                                                 .rate = "50 Hz",
                                                 .writers = {"uSimSensors"}});
inline const auto kDepthSensor = Declare<double>(
    "DEPTH_SENSOR", "depth of the body origin from pressure",
    {.unit = "m", .frame = "down from the surface", .rate = "20 Hz", .writers = {"uSimSensors"}});
inline const auto kDvlData = Declare<DvlSample>(
    "DVL_DATA", "Doppler velocity log: velocity, altitude, four slant ranges",
    {.unit = "m/s, m", .frame = "body FRD", .rate = "5 Hz", .writers = {"uSimSensors"}});
inline const auto kGpsData = Declare<GpsFix>(
    "GPS_DATA", "GPS fix in the mission's local frame",
    {.unit = "m", .frame = "NED", .rate = "1 Hz at the surface", .writers = {"uSimSensors"}});
inline const auto kObstacleSonar = Declare<SonarPing>(
    "OBSTACLE_SONAR", "echoes of the sonar that looks ahead for obstacles, by beam",
    {.unit = "m, rad", .frame = "body FRD", .rate = "4 Hz", .writers = {"uSimSensors"}});
inline const auto kUsblFix = Declare<UsblFix>(
    "USBL_FIX",
    "fix by an acoustic positioning system; heard if pNav's `sources` "
    "name acoustic_fix",
    {.unit = "m", .frame = "NED", .rate = "as it comes", .writers = {"a driver of the vehicle's"}});
inline const auto kCameraFrame = Declare<CameraFrame>(
    "CAMERA_FRAME", "down-looking image, 8-bit BGR",
    {.unit = "px, s", .frame = "image", .rate = "4 Hz", .writers = {"uSimCamera"}});
inline const auto kGroundContrast = Declare<GroundContrast>(
    "GROUND_CONTRAST", "how strongly the ground stands out in the image, spread over mean",
    {.unit = "1, s", .rate = "1 Hz", .writers = {"pDetect", "uSimCamera"}});
inline const auto kDetections = Declare<Detections>(
    "DETECTIONS", "boxes of each frame, also of empty ones",
    {.unit = "px, s", .frame = "image", .rate = "4 Hz", .writers = {"pDetect", "uSimCamera"}});
}  // namespace topics

}  // namespace limpet
