// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "estimation/navigation/source_block.hpp"
#include "estimation/replay/sensor_stream.hpp"
#include "limpet/logbook/alog_reader.hpp"
#include "limpet/vehicle_file/vehicle_file.hpp"

namespace limpet {

/// What the sensors of a logged run said that dead reckoning usually stands on, as a stream:
/// IMU_DATA, FOG_YAW_RATE, DVL_DATA, DEPTH_SENSOR, GPS_DATA, DETECTIONS and THRUSTER_COMMAND, each
/// as it was logged, in order of arrival.
class LoggedStream {
 public:
  /// `vehicle`: camera, and where and how turned the DVL is. Without one the DVL looks ahead.
  LoggedStream(const std::optional<VehicleFile>& vehicle, double object_radius_m);

  /// `start`: MOOS time of the log's start [s]. False for another variable.
  bool Take(const AlogEntry& entry, double start);
  [[nodiscard]] const SensorStream& stream() const { return stream_; }
  /// Entries of these variables that make no sense.
  [[nodiscard]] std::size_t bad_entries() const { return bad_entries_; }

 private:
  Eigen::Matrix3d R_BD_ = Eigen::Matrix3d::Identity();  ///< body from the DVL's own frame
  std::vector<std::unique_ptr<MotionSensor>> sensors_ = UsualSensors();
  SensorStream stream_;
  std::size_t bad_entries_ = 0;
};

}  // namespace limpet
