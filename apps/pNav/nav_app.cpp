// SPDX-License-Identifier: MIT
#include "apps/pNav/nav_app.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include <mrpt/obs/CObservation.h>

#include "apps/pNav/class_radii.hpp"
#include "apps/pNav/nav_block.hpp"
#include "estimation/navigation/observation_forms.hpp"
#include "estimation/navigation/sensor_beliefs.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/core/frames.hpp"
#include "limpet/objects/lens_box.hpp"

namespace limpet {
namespace {

constexpr Seconds kRealPause(0.5);  // real time that mail may take: at warp it is more

AttitudeParams AttitudeParamsOf(const NavApp::Params& params, const SensorSheets& sheets) {
  AttitudeParams result = BelievedAttitude(sheets);
  result.alignment = params.alignment;
  return result;
}

NavigatorParams NavigatorParamsOf(const NavApp::Params& params, const VehicleFile& vehicle) {
  NavigatorParams result;
  BelieveSheets(vehicle.sensors, result);
  BelieveHull(vehicle.params, result);
  result.odometry.drive = BelievedDrive(vehicle.params);
  // Anywhere within reach: of a uniform disc each axis has half the radius as its 1-sigma.
  result.odometry.unknown_velocity =
      0.5 * (vehicle.params.top_speed.value() + params.strongest_current.value());
  result.velocity_gate.jump = params.dvl_jump;
  result.frame_wait = params.frame_wait;
  result.camera = params.camera.geometry();
  result.node_period = params.node_period;
  result.node_distance = params.node_distance;
  result.objects.model.radius_m = params.opi_radius.value();
  result.objects.model.size_spread = params.opi_radius_spread;
  if (const auto radii = ParseClassRadii(params.opi_radius_by_class))
    result.objects.model.class_radius_m = *radii;  // else the block is refused
  result.objects.min_confidence = params.min_confidence;
  result.objects.gate.confused_class_share = params.wrong_color_share;
  result.objects.looks_to_confirm = params.looks_to_confirm;
  result.objects.confirm_log_odds = params.confirm_log_odds;
  result.session = params.session;
  if (params.compass_aids) result.compass.sigma = BelievedAttitude(vehicle.sensors).heading_sigma;
  return result;
}

}  // namespace

NavApp::NavApp(const AppContext& context, const Params& params)
    : NavApp(context, params,
             LoadMissionVehicle(context.Global(kVehicleFileGlobal), context.mission_folder)) {}

NavApp::NavApp(const AppContext& context, const Params& params, const VehicleFile& vehicle)
    : App(context),
      dvl_sheet_(vehicle.sensors.dvl),
      p_BS_(vehicle.sensors.sonar.p_BS),
      R_BD_(RotationFromRollPitchYaw(0.0, 0.0, vehicle.sensors.dvl.yaw.value())),
      stale_after_(std::max(params.stale_after, kRealPause * context.warp)),
      lens_(params.camera.lens()),
      attitude_(AttitudeParamsOf(params, vehicle.sensors)),
      navigator_(NavigatorParamsOf(params, vehicle)) {
  SubscribeIfWritten(topics::kObstacleSonar, &NavApp::OnSonar);
  Subscribe(topics::kSessionPrior, &NavApp::OnPrior);
  Subscribe(topics::kMapSnapshotRequest, &NavApp::OnSnapshotRequest);
}

void NavApp::SubscribeTo(const MeasurementSource& source,
                         std::function<bool(std::shared_ptr<mrpt::obs::CObservation>)> use) {
  const auto hear = [this, &source, use = std::move(use)](const MessagePtr& message) {
    if (!HasUsableStamp(message->name, message->time, message->source)) return;
    auto seen = source.Observe(message->time.value(), message->value);
    if (seen != nullptr && use(std::move(seen))) {
      ClearWarning(warnings::kBadMail, message->name);
    } else {
      Warn(warnings::kBadMail.Of(message->name), "makes no sense; sent by " + message->source);
    }
  };
  source.is_dispensable() ? SubscribeRawIfWritten(source.variable(), hear)
                          : SubscribeRaw(source.variable(), hear);
}

void NavApp::Hear(const std::string& name, std::unique_ptr<MeasurementSource> source) {
  if (auto sensor = TakeMotionSensor(source)) {
    HearMotion(std::move(sensor));
  } else {
    HearAiding(name, std::move(source));
  }
}

void NavApp::HearMotion(std::unique_ptr<MotionSensor> sensor) {
  using Seen = std::shared_ptr<mrpt::obs::CObservation>;
  SubscribeTo(*sensor, [this, heard = sensor.get()](const Seen& seen) {
    const auto reading = heard->ReadingOf(*seen);
    if (reading) std::visit([this](const auto& one) { this->On(one); }, *reading);
    return reading.has_value();
  });
  sensors_.push_back(std::move(sensor));
}

void NavApp::HearAiding(const std::string& name, std::unique_ptr<MeasurementSource> source) {
  const MeasurementSource& heard = *source;
  const int number = navigator_.AddSource(std::move(source));
  aiding_.push_back({.name = name, .heard = {}});
  SubscribeTo(heard, [this, number](auto seen) {
    aiding_[static_cast<std::size_t>(number)].heard.Note(
        {.stamp = SecondsOf(*seen), .now = now().value()});
    navigator_.AddObservation(number, std::move(seen));
    return true;
  });
}

void NavApp::On(const YawRate& turning) {
  attitude_.AddFogRate(turning.t, RadiansPerSecond(turning.rate));
  if (std::isfinite(turning.rate)) {
    fog_.Note({.stamp = turning.t, .now = now().value()});
  }
}

void NavApp::On(const ThrusterShares& command) { navigator_.AddCommand(command); }

void NavApp::On(const InertialInput& sample) {
  const double t = sample.t;
  const int outliers = attitude_.outliers();
  const bool is_good = attitude_.AddInertial(sample);
  imu_refusals_.Note(t, attitude_.outliers() != outliers);
  if (!is_good) {
    return;
  }
  imu_.Note({.stamp = t, .now = now().value()});
  navigator_.AddSpecificForce(t, sample.force_B);
  if (attitude_.is_aligned() && t - last_attitude_t_ >= Navigator::kAttitudePeriod) {
    navigator_.AddAttitude(*attitude_.estimate());
    if (attitude_.has_heading()) {
      navigator_.AddCompass(t, Radians(WrapAngle(sample.heading - attitude_.estimate()->yaw)));
    }
    last_attitude_t_ = t;
  }
}

void NavApp::On(const BottomTrack& ping) {
  const double t = ping.t;
  dvl_.Note({.stamp = t, .now = now().value()});
  ++dvl_pings_;
  dvl_pings_without_lock_ += ping.v_WD_D ? 0 : 1;
  std::optional<Eigen::Vector3d> velocity_B;
  if (ping.v_WD_D) {
    velocity_B = R_BD_ * *ping.v_WD_D;
    if (velocity_B->allFinite()) {
      lock_.Note({.stamp = t, .now = now().value()});
    }
  }
  if (ping.altitude) {
    navigator_.AddAltitude(t, Meters(*ping.altitude));
  }
  const int refused = navigator_.counts().velocities;
  navigator_.AddVelocity(t, velocity_B);
  if (velocity_B) velocity_refusals_.Note(t, navigator_.counts().velocities != refused);
  if (navigator_.has_started() && IsFresh(imu_, now().value())) {
    attitude_.SetBodyVelocity(navigator_.Estimate(t).v_B);
  }
}

void NavApp::On(const SlantRanges& ping) {
  if (!navigator_.has_started() || !IsFresh(imu_, now().value())) return;
  const NavigatorEstimate estimate = navigator_.Estimate(ping.t);
  const Pose& X_WB = estimate.X_WB;
  const Eigen::Vector3d p_dvl_W = X_WB.p_WB + RotationOf(X_WB) * dvl_sheet_.p_BD;
  Publish(topics::kNavBeams, PosedBeams{.north = p_dvl_W.x(),
                                        .east = p_dvl_W.y(),
                                        .down = p_dvl_W.z(),
                                        .roll = X_WB.roll,
                                        .pitch = X_WB.pitch,
                                        .yaw = X_WB.yaw,
                                        .b1 = ping.beams[0],
                                        .b2 = ping.beams[1],
                                        .b3 = ping.beams[2],
                                        .b4 = ping.beams[3],
                                        .sd_down = estimate.sd_p_W.z()});
}

void NavApp::On(const DepthReading& reading) {
  if (std::isfinite(reading.depth)) {
    depth_.Note({.stamp = reading.t, .now = now().value()});
  }
  navigator_.AddDepth(reading.t, Meters(reading.depth));
}

void NavApp::On(const PositionFix& fix) {
  ++gps_fixes_;
  gps_.Note({.stamp = fix.t, .now = now().value()});
  navigator_.AddGps(fix.t, fix.p_W, fix.sd);
}

void NavApp::On(const Detections& frame) {
  if (!HasUsableStamp(topics::kDetections.name, frame.exposure, "its exposure")) {
    return;
  }
  camera_.Note({.stamp = frame.exposure.value(), .now = now().value()});
  navigator_.AddFrame(lens_.is_pinhole() ? frame : Rectified(lens_, frame).frame);
}

void NavApp::OnPrior(const Stamped<SessionPrior>& prior) {
  FormerSession former = prior.value.former;
  const bool is_of_all =
      former.joint_cov_W.rows() == static_cast<Eigen::Index>(3 * former.objects.size());
  if (!is_of_all) former.joint_cov_W = {};
  navigator_.SetFormerSession(std::move(former));
}

void NavApp::OnSnapshotRequest(const Stamped<std::string>& /*why*/) {
  LandmarkCovariance message;
  for (const Landmark& landmark : navigator_.Landmarks()) {
    message.ids.push_back(landmark.id);
  }
  message.cov_W = navigator_.LandmarkCovariance();
  Publish(topics::kNavLandmarkJoint, message);
}

void NavApp::Tick(Seconds now) {
  navigator_.Advance(now.value());
  WatchSensors(now.value());
  WatchAiding(now.value());
  if (navigator_.has_started()) {
    PublishState(now.value());
    NoteTrack();
    PublishFrames();
    PublishLandmarks(now.value());
  }
}

void NavApp::PublishScalars(const NavigatorEstimate& estimate) {
  const MoosPose moos = MoosFromNed(estimate.X_WB.p_WB, estimate.X_WB.yaw);
  Publish(topics::kNavX, moos.x);
  Publish(topics::kNavY, moos.y);
  Publish(topics::kNavHeading, moos.heading_deg);
  Publish(topics::kNavYaw, moos.yaw);
  Publish(topics::kNavPitch, estimate.X_WB.pitch);
  Publish(topics::kNavRoll, estimate.X_WB.roll);
  Publish(topics::kNavDepth, moos.depth);
  const Eigen::Vector3d v_W = RotationOf(estimate.X_WB) * estimate.v_B;
  Publish(topics::kNavSpeed, v_W.head<2>().norm());
  if (estimate.altitude) {
    Publish(topics::kNavAltitude, *estimate.altitude);
  }
}

void NavApp::PublishState(double now) {
  const NavigatorEstimate estimate = navigator_.Estimate(now);
  NavState state;
  state.north = estimate.X_WB.p_WB.x(), state.east = estimate.X_WB.p_WB.y();
  state.down = estimate.X_WB.p_WB.z();
  state.roll = estimate.X_WB.roll, state.pitch = estimate.X_WB.pitch;
  state.yaw = estimate.X_WB.yaw;
  state.u = estimate.v_B.x(), state.v = estimate.v_B.y(), state.w = estimate.v_B.z();
  state.yaw_rate = estimate.yaw_rate;
  state.velocity_age = estimate.velocity_age;
  state.altitude = estimate.altitude;
  state.sd_north = estimate.sd_p_W.x(), state.sd_east = estimate.sd_p_W.y();
  state.sd_down = estimate.sd_p_W.z(), state.sd_yaw = estimate.sd_yaw;
  AddSources(now, state);
  if (*state.is_valid) {
    PublishScalars(estimate);
  }
  Publish(topics::kNavState, state);
  if (*state.is_valid) {
    PublishDeadReckoning(now);
    PublishCurrent(now);
  }
}

void NavApp::PublishDeadReckoning(double now) {
  const Pose reckoned = navigator_.DeadReckoned(now);
  Publish(topics::kNavDeadReckoning, DeadReckoning{.north = reckoned.p_WB.x(),
                                                   .east = reckoned.p_WB.y(),
                                                   .down = reckoned.p_WB.z(),
                                                   .yaw = reckoned.yaw});
}

void NavApp::PublishCurrent(double now) {
  constexpr double kPeriod = 1.0;  // [s]
  const std::optional<WaterState> water = navigator_.Water(now);
  if (!water || now - current_t_ < kPeriod - 1e-6) {
    return;
  }
  current_t_ = now;
  Publish(topics::kNavCurrent, WaterCurrent{.north = water->current_W.x(),
                                            .east = water->current_W.y(),
                                            .sd = water->sd_current_W.norm() / std::sqrt(2.0)});
}

void NavApp::NoteTrack() {
  const std::vector<SmoothedPose> newer = navigator_.Smoothed(track_watch_.noted());
  for (const SmoothedPose& pose : newer) {
    place_sigmas_.Note(pose.t, pose.X_WB.p_WB.head<2>());
  }
  track_watch_.Note(newer);
}

PlaceSigma NavApp::NewestSigma() {
  constexpr double kEvery = 2.0;  // [s] it changes slowly
  const int newest = place_sigmas_.noted() - 1;
  if (!sigma_node_ || place_sigmas_.TimeOf(newest) - place_sigmas_.TimeOf(*sigma_node_) >= kEvery) {
    sigma_node_ = newest;
    newest_sigma_ = place_sigmas_.Of(newest, navigator_.smoother());
  }
  return newest_sigma_;
}

std::vector<std::array<double, 3>> NavApp::TrackSigmas() const {
  constexpr int kMost = 25;  // a covariance takes up to a millisecond
  const int last = place_sigmas_.noted() - 1, step = 1 + last / kMost;
  std::vector<std::array<double, 3>> sigmas;
  for (int node = last % step; node <= last; node += step) {
    const PlaceSigma sigma = place_sigmas_.Of(node, navigator_.smoother());
    sigmas.push_back({place_sigmas_.TimeOf(node), sigma.absolute, sigma.beside});
  }
  return sigmas;
}

void NavApp::PublishFrames() {
  for (ObservedFrame& frame : navigator_.TakeFrames()) {
    frame.sigma = NewestSigma();
    Publish(topics::kNavCameraFrame, frame);
  }
}

void NavApp::PublishLandmarks(double now) {
  constexpr double kPeriod = 0.5;  // [s]
  if (navigator_.landmark_version() == landmark_version_ || now - landmarks_t_ < kPeriod - 1e-6) {
    return;
  }
  landmark_version_ = navigator_.landmark_version();
  landmarks_t_ = now;
  if (auto shift = track_watch_.Compare(navigator_.Smoothed())) {
    shift->sigmas = TrackSigmas();
    Publish(topics::kNavTrackShift, *shift);
  }
  Publish(topics::kNavLandmarks, Landmarks{navigator_.Landmarks()});
}

bool NavApp::RepeatsEchoes(const SonarPing& ping) {
  const bool has_echo = std::ranges::any_of(ping.ranges, [](double range) { return range > 0.0; });
  const bool repeats = has_echo && ping.ranges == former_echoes_;
  former_echoes_ = ping.ranges;
  return repeats;
}

void NavApp::OnSonar(const Stamped<SonarPing>& ping) {
  // What hangs shows an obstacle that goes along with the vehicle.
  if (RepeatsEchoes(ping.value)) return;
  sonar_.Note({.stamp = ping.time.value(), .now = now().value()});
  if (!navigator_.has_started() || !IsValid(now().value())) return;
  const Pose X_WB = navigator_.Estimate(ping.time.value()).X_WB;
  const Eigen::Vector3d p_sonar_W = X_WB.p_WB + RotationOf(X_WB) * p_BS_;
  Publish(topics::kNavSonar, PosedSonar{.north = p_sonar_W.x(),
                                        .east = p_sonar_W.y(),
                                        .down = p_sonar_W.z(),
                                        .roll = X_WB.roll,
                                        .pitch = X_WB.pitch,
                                        .yaw = X_WB.yaw,
                                        .ping = ping.value});
}

namespace {

/// Registers as LIMPET_REGISTER_APP does, with the keys of the sources that a block names.
const bool is_registered = [] {
  AppEntry entry = MakeAppEntry<NavApp>(10.0);
  entry.create = CreateNavApp;
  entry.check = CheckNavBlock;
  AppRegistry()["pNav"] = std::move(entry);
  return true;
}();

}  // namespace
}  // namespace limpet
