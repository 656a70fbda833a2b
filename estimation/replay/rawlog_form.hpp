// SPDX-License-Identifier: MIT
// What writer and reader of rawlogs agree on. The classes are MRPT's own, so that its viewers and
// tools read every observation; what MRPT has no class for (boxes, beams, 1-sigmas of an attitude)
// is numbers of a CObservationRawDAQ. A comment would not do: CRawlog keeps only the last one.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <mrpt/core/Clock.h>

namespace limpet::rawlog {

/// What the comment with the lines of meta.csv begins with: MRPT keeps no label of a comment.
inline constexpr const char* kMetaBegin = "key,v1,v2,...\n";

// Labels of observations.
inline constexpr const char* kAttitude = "attitude";             ///< roll, pitch, yaw [rad]
inline constexpr const char* kAttitudeSigma = "attitude_sigma";  ///< of what follows [rad]
inline constexpr const char* kImu = "imu";                       ///< force, rates, heading
inline constexpr const char* kFog = "fog";                       ///< rate about body z [rad/s]
inline constexpr const char* kDvl = "dvl";          ///< velocity in body axes, altitude
inline constexpr const char* kBeams = "dvl_beams";  ///< of the ping before [m]
inline constexpr const char* kDepth = "depth";      ///< IMU_Z: down [m]
inline constexpr const char* kGps = "gps";          ///< north, east [m]
inline constexpr const char* kBoxes = "boxes";      ///< frame, exposure, arrival, then five per box

inline constexpr std::size_t kNumbersOfAFrame = 3;
inline constexpr std::size_t kNumbersOfABox = 5;  ///< u, v, w, h, confidence

/// MRPT counts ticks of 0.1 us since 1601; a stream's seconds are since 1970, or since its start.
inline constexpr std::int64_t kTicksTo1970 = 116'444'736'000'000'000;

/// Nothing for what is no time between the years 1653 and 29000.
[[nodiscard]] inline std::optional<mrpt::Clock::time_point> TimeOf(double t) {
  if (!(t > -1e10 && t < 8e11)) return std::nullopt;
  const auto ticks = static_cast<std::int64_t>(std::llround(static_cast<long double>(t) * 1e7L));
  return mrpt::Clock::time_point(mrpt::Clock::duration(ticks + kTicksTo1970));
}

/// The double next to the decimal number of seconds: what a text of up to seven digits behind the
/// point was read as comes back with every bit.
[[nodiscard]] inline double SecondsOf(mrpt::Clock::time_point time) {
  const std::int64_t ticks = time.time_since_epoch().count();
  return static_cast<double>((static_cast<long double>(ticks) - kTicksTo1970) / 1e7L);
}

}  // namespace limpet::rawlog
