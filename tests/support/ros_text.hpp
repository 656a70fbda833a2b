// SPDX-License-Identifier: MIT
// Topics of ROS as CSV, made up: a DVL with four beams 22 deg from the vertical, ahead, to
// starboard, astern and to port, and a depth sensor.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include <Eigen/Core>
#include <fmt/format.h>

namespace limpet {

inline constexpr double kMadeTilt = 22.0 * 3.14159265358979323846 / 180.0;

inline std::string DvlHeader() {
  return "%time,field.header.seq,field.header.stamp,field.dataGood0,field.dataGood1,"
         "field.dataGood2,field.dataGood3,field.altitudeBeam0,field.altitudeBeam1,"
         "field.altitudeBeam2,field.altitudeBeam3,field.bottomVelocityBeam0,"
         "field.bottomVelocityBeam1,field.bottomVelocityBeam2,field.bottomVelocityBeam3,"
         "field.velocityInst0,field.velocityInst1,field.velocityInst2,field.velocityInstFlag,"
         "field.roll,field.pitch,field.heading,field.altitude\n";
}

/// Of one ping; `bad_beam` of 0 to 3 is flagged bad.
struct MadePing {
  double t = 0.0;
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  int bad_beam = -1;
  bool has_velocity = true;
  double heading = 0.0, altitude = 3.0;
};

inline std::string Nanoseconds(double t) {
  return std::to_string(1'700'000'000'000'000'000 + static_cast<std::int64_t>(std::round(1e9 * t)));
}

inline std::string DvlLine(const MadePing& ping) {
  const double s = std::sin(kMadeTilt), c = std::cos(kMadeTilt);
  const Eigen::Vector3d& v = ping.velocity;
  const std::array speeds{s * v.x() + c * v.z(), s * v.y() + c * v.z(), -s * v.x() + c * v.z(),
                          -s * v.y() + c * v.z()};
  std::string good, ranges, along;
  for (int beam = 0; beam < 4; ++beam) {
    const bool is_good = beam != ping.bad_beam;
    good += is_good ? ",1" : ",0";
    ranges += is_good ? fmt::format(",{:.1f}", ping.altitude + 0.1 * beam) : ",0.0";
    along += is_good ? fmt::format(",{:.4f}", speeds[static_cast<std::size_t>(beam)]) : ",0.0";
  }
  const std::string time = Nanoseconds(ping.t);
  const Eigen::Vector3d shown = ping.has_velocity ? v : Eigen::Vector3d::Zero();
  return fmt::format("{},7,{}{}{}{},{:.4f},{:.4f},{:.4f},{},0.0,0.0,{:.1f},{:.1f}\n", time, time,
                     good, ranges, along, shown.x(), shown.y(), shown.z(),
                     ping.has_velocity ? 1 : 0, ping.heading, ping.altitude);
}

/// `pings` of them, five per second, of a vehicle that weaves and dives and rises again.
inline Eigen::Vector3d MadeVelocity(double t) {
  return {0.5 + 0.1 * std::sin(0.1 * t), 0.1 * std::sin(0.23 * t), 0.2 * std::sin(0.05 * t)};
}
inline std::string DvlText(int pings) {
  std::string text = DvlHeader();
  for (int i = 0; i < pings; ++i) {
    const double t = 0.2 * i;
    text += DvlLine({.t = t, .velocity = MadeVelocity(t), .bad_beam = i % 5 == 4 ? i % 4 : -1});
  }
  return text;
}

/// Ten per second, as that vehicle dives; `down` of -1 has it rise instead.
inline std::string DepthText(double seconds, double down = 1.0) {
  std::string text = "%time,field.header.seq,field.header.stamp,field.depth\n";
  for (int i = 0; i <= static_cast<int>(10.0 * seconds); ++i) {
    const double t = 0.1 * i, time_integral = 4.0 * (1.0 - std::cos(0.05 * t));
    text += fmt::format("{0},{1},{0},{2:.4f}\n", Nanoseconds(t), i, 20.0 + down * time_integral);
  }
  return text;
}

}  // namespace limpet
