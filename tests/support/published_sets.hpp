// SPDX-License-Identifier: MIT
// Published SLAM sets as their files have them: planar pose graphs, and odometry with ranges.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limpet/core/expected.hpp"

namespace limpet {

/// EDGE2: the pose `to` in the frame of the pose `from`: x, y [m], yaw [rad].
struct PlanarEdge {
  int from = 0, to = 0;
  Eigen::Vector3d motion = Eigen::Vector3d::Zero();
  Eigen::Vector3d variance = Eigen::Vector3d::Ones();
};
/// BR: bearing [rad] and range [m] of a landmark from a pose.
struct PlanarSighting {
  int pose = 0, landmark = 0;
  Eigen::Vector2d bearing_range = Eigen::Vector2d::Zero();
  Eigen::Vector2d sigma = Eigen::Vector2d::Ones();
};
/// VERTEX2, EDGE2, BR and EQUIV lines of a .graph file.
struct PlanarGraph {
  std::vector<Eigen::Vector3d> poses;  ///< x, y, yaw as the file guesses them
  std::vector<PlanarEdge> edges;
  std::vector<PlanarSighting> sightings;
  int equivalents = 0;  ///< EQUIV lines: counted, not used
};
/// The error names file and line. Only diagonal information is understood; every pose has an edge
/// to the one before it.
[[nodiscard]] Expected<PlanarGraph> ReadPlanarGraph(const std::filesystem::path& file);

/// One row of odometry: way [m] and turn [rad] since the row before.
struct RollingStep {
  double t = 0.0, way = 0.0, turn = 0.0;
};
struct BeaconRange {
  double t = 0.0;
  int beacon = 0;
  double range = 0.0;
};
/// Planar odometry and ranges to beacons, with truth.
struct RangeSession {
  std::vector<RollingStep> steps;
  std::vector<BeaconRange> ranges;
  std::vector<Eigen::Vector4d> truth;  ///< t, x, y, yaw; empty if there is none
  std::map<int, Eigen::Vector2d> beacons;
};
/// <stem>_DR.txt and <stem>_TD.txt, and the truth in <stem>_.mat if that is there.
[[nodiscard]] Expected<RangeSession> ReadRangeSession(const std::filesystem::path& stem);

}  // namespace limpet
