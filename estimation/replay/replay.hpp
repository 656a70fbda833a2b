// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "estimation/navigation/navigator.hpp"
#include "estimation/replay/sensor_stream.hpp"

namespace limpet {

/// The navigator's parameters for a stream's vehicle.
[[nodiscard]] NavigatorParams ParamsForStream(const StreamMeta& meta);

struct ReplayAssociation {
  int frame = 0;
  int detection = 0;
  int landmark = -1;
};

/// The water and the vehicle in it, as known at that time [s].
struct TimedWater {
  double t = 0.0;
  WaterState water;
};

/// Everything `limpet nav` writes.
struct ReplayResult {
  std::vector<SmoothedPose> online, smoothed, reckoned;
  std::vector<Eigen::Matrix3d> online_covariance;  ///< of the positions of `online`, in W [m^2]
  std::vector<TimedWater> water;                   ///< about once a second
  std::vector<Landmark> landmarks;
  Eigen::MatrixXd landmark_covariance;  ///< joint, three rows each [m^2]
  FrameOffset former_offset;            ///< of the former session's frame in this one
  std::vector<ReplayAssociation> associations;
  std::vector<double> update_s;  ///< per node, up to its published pose
  SolveReport finish;
  NavigatorCounts counts;
};

/// Runs the navigator over a stream in order of arrival. `clock` [s] only times the updates;
/// `inspect`, if given, sees the navigator at the end. `former` is what an earlier session left.
[[nodiscard]] ReplayResult Replay(const SensorStream& stream, const NavigatorParams& params,
                                  const std::function<double()>& clock,
                                  const std::function<void(const Navigator&)>& inspect = {},
                                  const FormerSession& former = {});

}  // namespace limpet
