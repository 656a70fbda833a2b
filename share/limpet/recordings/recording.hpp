// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "estimation/replay/sensor_stream.hpp"

namespace limpet {

/// One ping of a DVL, in the instrument's own axes.
struct DvlPing {
  double t = 0.0;                                         ///< [s]
  std::array<std::optional<double>, 4> beam_speeds = {};  ///< along each beam [m/s]; empty: bad
  std::array<std::optional<double>, 4> beam_ranges = {};  ///< as the instrument says them [m]
  std::optional<Eigen::Vector3d> v_D;                     ///< that it makes of them [m/s]
  std::optional<double> altitude;                         ///< [m]
};

struct TimedNumber {
  double t = 0.0, value = 0.0;
};
struct TimedPlace {
  double t = 0.0;
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();  ///< north, east [m]
};
/// What a vehicle's own navigation said of itself.
struct OwnNavigation {
  std::vector<TimedPlace> places;
  std::vector<TimedNumber> headings;   ///< clockwise from north [rad]
  std::vector<TimedNumber> speeds;     ///< [m/s]
  std::vector<TimedNumber> altitudes;  ///< [m]

  [[nodiscard]] bool is_empty() const {
    return places.empty() && headings.empty() && speeds.empty();
  }
};

/// Something that a recording was looked through for and does not hold.
struct MissingData {
  std::string what;    ///< `heading`
  std::string reason;  ///< `dvl.csv: field.heading is 0 in all of 5564 rows`
  std::string cost;    ///< what cannot be had without it
};

/// What was measured, as far as the files of another vehicle tell it.
struct Recording {
  std::string name;  ///< of the file or folder, for messages
  std::vector<DvlPing> pings;
  std::vector<DepthReading> depths;
  OwnNavigation own{};
  std::vector<MissingData> missing;
  std::vector<std::string> left_out;     ///< files and rows that are not in here, and why
  std::vector<std::string> doubts = {};  ///< what may be otherwise than it was taken
};

/// What a stream of our own form, or of a rawlog, says of the same.
[[nodiscard]] Recording RecordingOf(const SensorStream& stream, const std::string& name);

}  // namespace limpet
