// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "estimation/attitude/attitude_filter.hpp"
#include "estimation/navigation/navigator.hpp"
#include "estimation/replay/sensor_stream.hpp"
#include "estimation/replay/source_feed.hpp"
#include "limpet/core/lens_model.hpp"
#include "limpet/vehicle/sensor_sheets.hpp"
#include "limpet/vehicle/vehicle_params.hpp"

namespace limpet {

/// The navigator's parameters for a stream's vehicle, as its meta.csv has it.
[[nodiscard]] NavigatorParams ParamsForStream(const StreamMeta& meta);
/// The navigator's parameters for a vehicle by its file's hull, sheets and camera; objects are
/// those of the stream, whose velocities are in the vehicle's axes, however its DVL is turned.
[[nodiscard]] NavigatorParams ParamsForVehicle(const VehicleParams& hull,
                                               const SensorSheets& sheets,
                                               const CameraModel& camera, const StreamMeta& meta);
/// Why boxes of the stream cannot be used: it has frames, and its meta.csv no camera.
[[nodiscard]] std::optional<std::string> MissingCamera(const SensorStream& stream);

struct ReplayAssociation {
  int frame = 0;
  int detection = 0;
  std::optional<int> landmark = std::nullopt;
};

/// What is estimated beside pose and objects, as known at that time [s].
struct TimedStates {
  double t = 0.0;
  std::vector<NamedState> states;
};

/// Everything `limpet nav` writes.
struct ReplayResult {
  std::vector<SmoothedPose> online, smoothed, reckoned;
  std::vector<Eigen::Matrix3d> online_covariance_W;  ///< of the positions of `online` [m^2]
  std::vector<TimedStates> states;                   ///< about once a second
  std::vector<Landmark> landmarks;
  Eigen::MatrixXd landmark_covariance;  ///< joint, three rows each [m^2]
  FrameOffset former_offset;            ///< of the former session's frame in this one
  std::vector<ReplayAssociation> associations;
  std::vector<double> update_s;  ///< per node, up to its published pose
  SolveReport finish;
  NavigatorCounts counts;
  SourceUse sources;     ///< of the stream's further sensors
  bool has_fix = false;  ///< that was believed; else places count from the start
  std::optional<FixErrorBelief::Ratio> fix_error = {};  ///< sigma of fixes over what they state
  std::optional<double> surface_reading = {};    ///< of the depth sensor, where fixes came [m]
  std::vector<Disagreement> disagreements = {};  ///< sensors that cannot all be right
  std::vector<UnplacedObject> unplaced = {};     ///< what boxes showed, and has no place
};

/// What makes of a stream's rows what the navigator takes.
struct ReplaySensors {
  AttitudeParams attitude;                        ///< for inertial samples, instead of attitudes
  LensModel lens = LensModel(CameraModel(), {});  ///< boxes are rectified by it
  SourceFeed::Sources sources = {};               ///< further ones that are heard, by name
};
[[nodiscard]] ReplaySensors SensorsForStream(const StreamMeta& meta);

/// Runs the navigator over a stream in order of arrival. `clock` [s] only times the updates;
/// `inspect`, if given, sees the navigator at the end. `former` is what an earlier session left.
[[nodiscard]] ReplayResult Replay(const SensorStream& stream, const NavigatorParams& params,
                                  const std::function<double()>& clock,
                                  const std::function<void(const Navigator&)>& inspect = {},
                                  const FormerSession& former = {},
                                  const ReplaySensors& sensors = {});

}  // namespace limpet
