// SPDX-License-Identifier: MIT
// A sensor stream as a rawlog of MRPT: a gzip file of observations in order of arrival, of MRPT's
// own classes alone. World axes are north, east, down; body axes forward, right, down.
//   label           class                   holds
//                   CObservationComment     first: the lines of meta.csv
//   attitude        CObservationIMU         IMU_ROLL, IMU_PITCH, IMU_YAW
//   attitude_sigma  CObservationRawDAQ      their 1-sigmas, where they change
//   imu             CObservationIMU         IMU_X_ACC.., IMU_WX.., IMU_YAW: the compass' heading
//   fog             CObservationIMU         IMU_WZ alone
//   dvl             CObservationIMU         IMU_X_VEL.. in body axes if it has lock, IMU_ALTITUDE
//   dvl_beams       CObservationRawDAQ      four slant ranges of the ping before; nan: no echo
//   depth           CObservationIMU         IMU_Z
//   gps             CObservationRobotPose   north and east with covariance
//   boxes           CObservationRawDAQ      AIN_double: frame, exposure, arrival, then u, v, w, h,
//                                           confidence of each box; AIN_8bits: a class per line
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "estimation/replay/sensor_stream.hpp"
#include "limpet/core/expected.hpp"

namespace limpet {

/// What the comment with the lines of meta.csv begins with: MRPT keeps no label of a comment.
inline constexpr const char* kRawlogMetaBegin = "key,v1,v2,...\n";

struct PackedRawlog {
  std::string bytes;      ///< of the file
  int untimely_rows = 0;  ///< left out: their time is none that MRPT can say
};
/// All but times is kept with every bit; times to 0.1 us.
[[nodiscard]] PackedRawlog ToRawlog(const SensorStream& stream);

/// `bytes` are unpacked; `name` is what errors call them. Also takes what is of these classes and
/// fields in other people's rawlogs, in sensory frames too, and GGA of CObservationGPS, north and
/// east of the first. What is of other classes, what is damaged, and in a rawlog of ours what comes
/// again bit for bit, is passed over, and the stream says so.
[[nodiscard]] Expected<SensorStream> ParseRawlog(std::string_view bytes, const std::string& name);
/// The error names the file.
[[nodiscard]] Expected<SensorStream> LoadRawlog(const std::filesystem::path& file);

}  // namespace limpet
