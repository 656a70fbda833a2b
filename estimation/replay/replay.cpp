// SPDX-License-Identifier: MIT
#include "estimation/replay/replay.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "estimation/navigation/sensor_beliefs.hpp"
#include "limpet/core/long_ago.hpp"
#include "limpet/objects/lens_box.hpp"

namespace limpet {
namespace {

constexpr Seconds kFixWait(5.0);        // a stream may begin under water
constexpr double kArrival = 10.0;       // [s] that a row may be behind its measurement
constexpr double kSilence = 0.3;        // [s]
constexpr double kOnlinePeriod = 0.19;  // [s] between rows of online.csv
constexpr double kStatesPeriod = 0.99;  // [s] between those of states.csv

/// Feeds one row after the other and keeps what the estimator says.
class Replayer {
 public:
  Replayer(const SensorStream& stream, const NavigatorParams& params,
           const std::function<double()>& clock, const FormerSession& former,
           const ReplaySensors& sensors)
      : navigator_(params),
        filter_(sensors.attitude),
        lens_(sensors.lens),
        clock_(clock),
        feed_(stream.source_rows, sensors.sources, navigator_) {
    navigator_.SetFormerSession(former);
  }

  void operator()(const AttitudeEstimate& row) {
    navigator_.AddAttitude(row);
    // The other sensors' rows drive the estimator; attitude alone does only when they are silent.
    if (row.t - now_ > kSilence) AdvanceTo(row.t);
  }
  void operator()(const YawRate& row) { filter_.AddFogRate(row.t, RadiansPerSecond(row.rate)); }
  void operator()(const InertialInput& row) {
    if (!filter_.AddInertial(row)) {
      ++refused_inertial_;
      return;
    }
    navigator_.AddSpecificForce(row.t, row.force_B);
    if (filter_.is_aligned() && row.t - attitude_t_ >= Navigator::kAttitudePeriod) {
      attitude_t_ = row.t;
      (*this)(*filter_.estimate());
    }
  }
  void operator()(const DvlRow& row) {
    navigator_.AddVelocity(row.t, row.v_WD_B);
    if (row.altitude) navigator_.AddAltitude(row.t, Meters(*row.altitude));
    AdvanceTo(row.t);
    const bool is_filtering = filter_.estimate().has_value() && navigator_.has_started();
    if (is_filtering) filter_.SetBodyVelocity(navigator_.Estimate(now_).v_B);
  }
  void operator()(const ThrusterShares& row) { navigator_.AddCommand(row); }
  void operator()(const DepthReading& row) { navigator_.AddDepth(row.t, Meters(row.depth)); }
  void operator()(const PositionFix& row) {
    navigator_.AddGps(row.t, row.p_W, row.sd);
    AdvanceTo(row.t);
  }
  void operator()(const FrameRow& row) {
    if (lens_.is_pinhole()) {
      navigator_.AddFrame(row.frame);
    } else {
      RectifiedFrame rectified = Rectified(lens_, row.frame);
      navigator_.AddFrame(rectified.frame);
      numbers_[row.frame.frame] = std::move(rectified.numbers);
    }
    for (int i = 0; i < static_cast<int>(row.frame.boxes.size()); ++i) {
      landmark_of_[{row.frame.frame, i}] = std::nullopt;
    }
    AdvanceTo(row.arrival);
  }

  [[nodiscard]] const Navigator& navigator() const { return navigator_; }

  ReplayResult Finish() {
    result_.finish = navigator_.Finish();
    result_.smoothed = navigator_.Smoothed();
    result_.landmarks = navigator_.Landmarks();
    result_.landmark_covariance = navigator_.LandmarkCovariance();
    if (navigator_.has_started()) result_.states.push_back({now_, navigator_.Sizes()});
    result_.former_offset = navigator_.former_offset();
    result_.counts = navigator_.counts();
    result_.sources = feed_.Use();
    result_.has_fix = navigator_.has_fix();
    result_.fix_error = navigator_.fix_error();
    result_.disagreements = navigator_.Disagreements();
    result_.unplaced = navigator_.tracker().Unplaced();
    result_.counts.stale_samples += refused_inertial_;
    result_.counts.looks = navigator_.tracker().rejected_observations();
    for (const TrackedObject& object : navigator_.tracker().objects()) {
      for (const Observation& one : object.observations) {
        if (object.is_landmark()) landmark_of_[{one.frame, NumberOf(one)}] = object.id();
      }
    }
    for (const auto& [box, landmark] : landmark_of_) {
      result_.associations.push_back({box.first, box.second, landmark});
    }
    return std::move(result_);
  }

 private:
  /// Number of the observation's box among the detector's boxes of its frame.
  [[nodiscard]] int NumberOf(const Observation& one) const {
    const auto frame = numbers_.find(one.frame);
    return frame == numbers_.end() ? one.detection
                                   : frame->second.at(static_cast<std::size_t>(one.detection));
  }
  void AdvanceTo(double t) {
    // The attitude's clock, which leaps are kept from, bounds everybody's.
    const std::optional<double> newest = navigator_.attitude_time();
    if (!std::isfinite(t) || !newest || t > *newest + kArrival) return;
    now_ = std::max(now_, t);
    feed_.FeedUpTo(now_);
    const int before = navigator_.node_count();
    const double start = clock_();
    navigator_.Advance(now_);
    static_cast<void>(navigator_.TakeFrames());  // nobody maps here: they would pile up
    const int added = navigator_.node_count() - before;
    const bool is_due = result_.online.empty() || now_ - result_.online.back().t >= kOnlinePeriod;
    if (!navigator_.has_started() || (added == 0 && !is_due)) {
      return;
    }
    if (const auto reading = navigator_.surface_reading()) result_.surface_reading = reading;
    const NavigatorEstimate estimate = navigator_.Estimate(now_);
    for (int i = 0; i < added; ++i) {
      result_.update_s.push_back((clock_() - start) / added);
    }
    if (is_due) {
      result_.online.push_back({now_, estimate.X_WB});
      result_.online_covariance_W.push_back(estimate.covariance_p_W);
      result_.reckoned.push_back({now_, navigator_.DeadReckoned(now_)});
      KeepStates();
    }
  }

  void KeepStates() {
    if (!result_.states.empty() && now_ - result_.states.back().t < kStatesPeriod) return;
    result_.states.push_back({now_, navigator_.States(now_)});
  }

  Navigator navigator_;
  AttitudeFilter filter_;
  double attitude_t_ = kLongAgo;
  int refused_inertial_ = 0;
  LensModel lens_;
  std::map<int, std::vector<int>> numbers_;  ///< of a frame's rectified boxes
  const std::function<double()>& clock_;
  SourceFeed feed_;
  double now_ = kLongAgo;
  std::map<std::pair<int, int>, std::optional<int>> landmark_of_;
  ReplayResult result_;
};

/// What the sensors state of themselves in place of what is usual, with the same margins.
void TakeNoise(const StatedNoise& stated, NavigatorParams& params) {
  const StatedNoise usual;
  OdometryParams& odometry = params.odometry;
  odometry.velocity_noise *= stated.velocity / usual.velocity;
  odometry.water.velocity_noise *= stated.velocity / usual.velocity;
  params.depth_sigma = Meters(params.depth_sigma.value() * (stated.depth / usual.depth));
  params.tilt_sigma = Radians(params.tilt_sigma.value() * (stated.tilt / usual.tilt));
}

}  // namespace

NavigatorParams ParamsForStream(const StreamMeta& meta) {
  NavigatorParams params;
  params.camera = LensModel(meta.camera, meta.distortion).rectified();
  params.odometry.dvl_B = meta.dvl_B;
  TakeNoise(meta.noise, params);
  params.odometry.yaw_walk = meta.yaw_random_walk;
  params.odometry.yaw_bias = meta.yaw_bias_sigma;
  BelieveVelocityErrors({.scale = meta.dvl_scale_sigma,
                         .misalignment = meta.dvl_misalign_sigma,
                         .bias_mps = meta.dvl_bias_sigma},
                        params.odometry);
  params.objects.model.radius_m = meta.opi_radius;
  params.objects.model.size_spread = kSizeSpread;  // a stream says one radius for all
  params.fix_wait = kFixWait;
  BelieveMounting(SensorSheets{}, params);  // a stream says nothing of it
  return params;
}

NavigatorParams ParamsForVehicle(const VehicleParams& hull, const SensorSheets& sheets,
                                 const CameraModel& camera, const StreamMeta& meta) {
  NavigatorParams params;
  BelieveHull(hull, params);
  params.odometry.drive = BelievedDrive(hull);
  BelieveSheets(sheets, params);
  params.camera = camera;
  params.objects.model.radius_m = meta.opi_radius;
  params.objects.model.size_spread = kSizeSpread;  // a stream says one radius for all
  params.fix_wait = kFixWait;
  return params;
}

ReplaySensors SensorsForStream(const StreamMeta& meta) {
  ReplaySensors sensors{.attitude = {}, .lens = LensModel(meta.camera, meta.distortion)};
  sensors.attitude.yaw_random_walk = Radians(meta.yaw_random_walk);
  sensors.attitude.yaw_bias_sigma = Radians(meta.yaw_bias_sigma);
  return sensors;
}

std::optional<std::string> MissingCamera(const SensorStream& stream) {
  const StreamMeta& meta = stream.meta;
  const bool has_frames = std::ranges::any_of(
      stream.rows, [](const StreamRow& row) { return std::holds_alternative<FrameRow>(row); });
  if (!has_frames || (meta.has_image_size && meta.has_intrinsics)) return std::nullopt;
  return std::string(meta.has_image_size ? "intrinsics_fx_fy_cx_cy" : "image_size") +
         ": is missing, and the stream has frames: no camera is known; say it here or give the "
         "vehicle's file with --vehicle";
}

ReplayResult Replay(const SensorStream& stream, const NavigatorParams& params,
                    const std::function<double()>& clock,
                    const std::function<void(const Navigator&)>& inspect,
                    const FormerSession& former, const ReplaySensors& sensors) {
  Replayer replayer(stream, params, clock, former, sensors);
  for (const StreamRow& row : stream.rows) {
    std::visit(replayer, row);
  }
  ReplayResult result = replayer.Finish();
  if (inspect) inspect(replayer.navigator());
  return result;
}

}  // namespace limpet
