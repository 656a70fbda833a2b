// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "limpet/core/camera_model.hpp"

namespace limpet {

/// How a run was made: everything a report says or needs beyond what was recorded.
struct ReportSettings {
  std::string version = "0.1.0";
  std::string mission;  ///< name of the mission's folder
  std::uint64_t seed = 1;
  std::string planner = "limpet";   ///< or paper
  std::string gain = "full";        ///< or coverage
  std::string camera = "rendered";  ///< or boxes
  CameraModel camera_geometry;
  double altitude_m = 4.0;      ///< survey altitude, for the footprint
  double highest_view_m = 6.5;  ///< from higher above the seabed the vehicle does not map
  double frame_rate_hz = 4.0;
  double object_radius_m = 0.5;
  double object_height_max_m = 2.0;
  double turning_radius_m = 3.0;  ///< least radius of planned turns
  /// Sessions of the run in order; each is compared with the one before it. Empty: not known.
  std::vector<std::string> sessions;
  bool has_scenario = true;              ///< false for a real dive: nobody knows the truth
  std::string command;                   ///< reproduces the run; no absolute path
  std::map<std::string, double> wall_s;  ///< session to wall time [s]; absent: unknown

  /// Image on a flat bottom from survey altitude: across and along the track [m].
  [[nodiscard]] std::array<double, 2> footprint_m() const {
    return {2.0 * altitude_m * camera_geometry.half_across(),
            2.0 * altitude_m * camera_geometry.half_along()};
  }
};

}  // namespace limpet
