// SPDX-License-Identifier: MIT
// What the sensors measure that dead reckoning stands on, whoever made them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <variant>

#include <Eigen/Core>

#include "estimation/attitude/inertial_input.hpp"
#include "estimation/navigation/position_fix.hpp"
#include "limpet/objects/frame.hpp"

namespace limpet {

/// Of a gyro that is better than the inertial unit's own.
struct YawRate {
  double t = 0.0, rate = 0.0;  ///< about body z [rad/s]
};
/// One ping of a DVL.
struct BottomTrack {
  double t = 0.0;
  std::optional<Eigen::Vector3d> v_WD_D;  ///< in the DVL's axes [m/s]; nothing without lock
  std::optional<double> altitude;         ///< of the DVL above the seabed [m]
};
/// How far the seabed is along each beam of one ping [m].
struct SlantRanges {
  double t = 0.0;
  std::array<std::optional<double>, 4> beams = {};
};
struct DepthReading {
  double t = 0.0, depth = 0.0;  ///< [m]
};

/// What the thrusters are told from `t` on: normalised thrust of each, -1 to 1, in the order of the
/// vehicle's file; zero of those that it has not.
struct ThrusterShares {
  static constexpr std::size_t kMost = 8;
  double t = 0.0;
  std::array<double, kMost> shares = {};
};

using MotionReading = std::variant<InertialInput, YawRate, BottomTrack, SlantRanges, DepthReading,
                                   PositionFix, Detections, ThrusterShares>;

}  // namespace limpet
