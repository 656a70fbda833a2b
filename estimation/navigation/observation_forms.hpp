// SPDX-License-Identifier: MIT
// How what dead reckoning stands on is written as observations: of classes of MRPT's own, so that
// its viewers and tools read every one. What MRPT has no class for (boxes, beams, commands) is
// numbers of a CObservationRawDAQ; a comment would not do: CRawlog keeps only the last one.
#pragma once

#include <memory>
#include <optional>

#include "estimation/navigation/motion_readings.hpp"

namespace mrpt::obs {
class CObservation;
}

namespace limpet {

/// Labels, which tell observations of one class apart.
namespace observation_labels {
inline constexpr const char* kAttitude = "attitude";             ///< roll, pitch, yaw [rad]
inline constexpr const char* kAttitudeSigma = "attitude_sigma";  ///< of what follows [rad]
inline constexpr const char* kImu = "imu";                       ///< force, rates, heading
inline constexpr const char* kFog = "fog";                       ///< rate about body z [rad/s]
inline constexpr const char* kDvl = "dvl";          ///< velocity in the DVL's axes, altitude
inline constexpr const char* kBeams = "dvl_beams";  ///< four slant ranges [m]; nan: no echo
inline constexpr const char* kDepth = "depth";      ///< IMU_Z: down [m]
inline constexpr const char* kGps = "gps";          ///< north, east [m]
inline constexpr const char* kBoxes = "boxes";      ///< frame, exposure, arrival, then five per box
inline constexpr const char* kThrusters = "thrusters";  ///< share of full thrust of each
}  // namespace observation_labels

/// Time of an observation [s], since 1970 or since a stream's start: the double next to the decimal
/// number of seconds, since MRPT counts ticks of 0.1 us. What a text of up to seven digits behind
/// the point was read as comes back with every bit, and so does any time of today.
[[nodiscard]] double SecondsOf(const mrpt::obs::CObservation& seen);
/// Gives an observation its time [s] and label; false if it is no time that MRPT can say, which is
/// one between the years 1653 and 29000.
[[nodiscard]] bool Stamp(double t, const char* label, mrpt::obs::CObservation& seen);

using ObservationPtr = std::shared_ptr<mrpt::obs::CObservation>;

/// Observations of readings, with every bit; nothing if the time is none that MRPT can say.
[[nodiscard]] ObservationPtr ObservationOf(const InertialInput& sample);
[[nodiscard]] ObservationPtr ObservationOf(const YawRate& turning);
[[nodiscard]] ObservationPtr ObservationOf(const BottomTrack& ping);
[[nodiscard]] ObservationPtr ObservationOf(const SlantRanges& ping);
[[nodiscard]] ObservationPtr ObservationOf(const DepthReading& reading);
[[nodiscard]] ObservationPtr ObservationOf(const PositionFix& fix);
[[nodiscard]] ObservationPtr ObservationOf(const ThrusterShares& command);
/// Takes when the boxes came [s], beside the exposure of `frame`.
[[nodiscard]] ObservationPtr ObservationOf(const Detections& frame, double arrival);

/// Readings of observations; nothing of one of another class, or without what such a reading
/// needs. They do not look at labels.
[[nodiscard]] std::optional<InertialInput> InertialOf(const mrpt::obs::CObservation& seen);
[[nodiscard]] std::optional<YawRate> YawRateOf(const mrpt::obs::CObservation& seen);
[[nodiscard]] std::optional<BottomTrack> BottomTrackOf(const mrpt::obs::CObservation& seen);
[[nodiscard]] std::optional<SlantRanges> SlantRangesOf(const mrpt::obs::CObservation& seen);
[[nodiscard]] std::optional<DepthReading> DepthOf(const mrpt::obs::CObservation& seen);
[[nodiscard]] std::optional<PositionFix> FixOf(const mrpt::obs::CObservation& seen);
[[nodiscard]] std::optional<ThrusterShares> ThrusterSharesOf(const mrpt::obs::CObservation& seen);
struct SeenFrame {
  Detections frame;
  double arrival = 0.0;   ///< [s]
  int refused_boxes = 0;  ///< of numbers that are none: empty boxes, which keep the numbering
};
[[nodiscard]] std::optional<SeenFrame> FrameOf(const mrpt::obs::CObservation& seen);

}  // namespace limpet
