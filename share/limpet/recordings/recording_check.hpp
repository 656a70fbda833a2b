// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "limpet/recordings/beam_geometry.hpp"
#include "limpet/recordings/own_navigation_check.hpp"
#include "limpet/recordings/recording.hpp"
#include "limpet/recordings/sample_figures.hpp"

namespace limpet {

/// Counts of the verdicts of limpet's own VelocityGate, without a prediction.
struct GateVerdicts {
  std::size_t good = 0, refused = 0, contested = 0, believed = 0;
};

/// What a vehicle went over ground: its level speed over time. Pauses of more than 1 s between two
/// velocities are not bridged.
struct PathLength {
  double length = 0.0;    ///< [m]
  double covered = 0.0;   ///< [s]
  double left_out = 0.0;  ///< in pauses [s]
};

/// How the instrument's altitude comes from its beams.
struct AltitudeRule {
  std::string rule;  ///< `the least of the beams`
  Differences differences;
};

/// How the DVL's third axis goes with the depth sensor: slope and correlation of its velocity over
/// the depth's rate. Both are 1 of a level vehicle if the axis points down.
struct VerticalAgreement {
  std::size_t count = 0;
  double slope = 0.0, correlation = 0.0;
};

struct DvlCheck {
  SampleTimes times;
  std::size_t with_velocity = 0, with_altitude = 0;
  double longest_without_velocity = 0.0;  ///< [s]
  std::size_t four_beams = 0, three_beams = 0, fewer_beams = 0;
  std::size_t velocity_from_beams = 0;  ///< the instrument gives none, three beams or more are good
  std::optional<BeamGeometry> geometry;
  Differences four, three;    ///< of the velocity of so many beams to the instrument's [m/s]
  Differences contradiction;  ///< between four beams [m/s]
  std::optional<AltitudeRule> altitude;
  GateVerdicts gate;
  PathLength path, gated_path;
};

struct DepthCheck {
  SampleTimes times;
  double least = 0.0, greatest = 0.0;           ///< [m]
  double fastest_down = 0.0, fastest_up = 0.0;  ///< over 2 s [m/s]
};

struct RecordingCheck {
  std::optional<DvlCheck> dvl;
  std::optional<DepthCheck> depth;
  std::optional<OwnNavigationCheck> own;
  std::optional<VerticalAgreement> vertical;  ///< nothing without both, or without any dive
};

[[nodiscard]] RecordingCheck Check(const Recording& recording);

}  // namespace limpet
