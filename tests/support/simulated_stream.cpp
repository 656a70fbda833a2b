// SPDX-License-Identifier: MIT
#include "tests/support/simulated_stream.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

#include "limpet/core/random.hpp"
#include "tests/support/sphere_box.hpp"

namespace limpet {
namespace {

constexpr double kFurthest = 6.0;  // [m] an object is seen from
constexpr double kRadians = std::numbers::pi / 180.0;

/// What the sensors make of it, row by row in order of arrival.
class Recorder {
 public:
  Recorder(const StreamScene& scene, const SimulatedGround& ground, SimulatedStream& out)
      : scene_(scene),
        ground_(ground),
        out_(out),
        random_(scene.seed, "sensors"),
        boxes_(scene.seed, "boxes") {
    StreamMeta& meta = out.stream.meta;
    const double tilt = scene.tilt_deg * kRadians;
    meta.camera.width_px = 640, meta.camera.height_px = 360;
    meta.camera.fx = meta.camera.fy = 490, meta.camera.cx = 320, meta.camera.cy = 180;
    meta.camera.p_BC = {0.25, 0.0, 0.15};
    meta.camera.R_BC << 0.0, -std::cos(tilt), std::sin(tilt),  //
        1.0, 0.0, 0.0,                                         //
        0.0, std::sin(tilt), std::cos(tilt);
    meta.noise.velocity *= scene.noise;
    meta.noise.depth *= scene.noise;
    meta.noise.tilt *= scene.noise;
    meta.yaw_bias_sigma = scene.yaw_bias_degph * kRadians / 3600.0;
    yaw_error_ = random_.Normal(1.0 * kRadians);
    scale_ = 1.0 + random_.Normal(meta.dvl_scale_sigma);
    misalign_ = random_.Normal(meta.dvl_misalign_sigma);
    for (int i = 0; i < 3; ++i)
      dvl_bias_(i) = random_.Normal(0.001);
    tilt_bias_ = {random_.Normal(0.002 * scene.noise), random_.Normal(0.002 * scene.noise)};
    depth_bias_ = random_.Normal(0.01);
    troubles_.emplace(scene, random_);
    camera_ = scene.errors.camera.mounting.Applied(meta.camera);
    p_BD_ = meta.dvl_B + scene.errors.dvl.mounting.off_B;
    R_DB_ = scene.errors.dvl.mounting.rotation().transpose();
  }

  void Step(int step, const SimulatedVehicle& vehicle) {
    const double t = step * kSimulationStep;
    TakeAttitude(t, vehicle);
    if (step % DvlSteps() == 2) TakeDvl(t, vehicle);
    if (step % 4 == 2) TakeDepth(t, vehicle.pose());
    if (step % 5 == 3) TakeFrame(t, vehicle);
    if (step % 20 == 10 && vehicle.is_up() && vehicle.pose().p_WB.z() < 0.5) TakeFix(t, vehicle);
    if (step % 4 == 0) {
      out_.truth.t.push_back(t);
      out_.truth.p.push_back(vehicle.pose().p_WB);
    }
  }

  void Finish() {
    AddFalseBoxes();
    std::ranges::stable_sort(rows_, {}, &Arrival::t);
    for (Arrival& row : rows_)
      out_.stream.rows.push_back(std::move(row.row));
    for (std::size_t i = 0; i < ground_.objects().size(); ++i) {
      out_.truth.landmarks.push_back({scene_.gone + static_cast<int>(i) + 1, ground_.objects()[i]});
    }
  }

 private:
  struct Arrival {
    double t;
    StreamRow row;
  };
  void TakeAttitude(double t, const SimulatedVehicle& vehicle) {
    const StreamMeta& meta = out_.stream.meta;
    const double drift = yaw_bias_.Step(kSimulationStep) * kSimulationStep;
    yaw_error_ += drift + random_.Normal(meta.yaw_random_walk * std::sqrt(kSimulationStep));
    yaw_error_ += kSimulationStep * gyro_.Of(vehicle.yaw_rate(), Seconds(t));
    const Pose& X = vehicle.pose();
    const double noise = scene_.true_noise, stamp = attitude_stamp_.StampOf(Seconds(t)).value();
    const double roll_error = noise * roll_error_.Step(kSimulationStep);
    const double pitch_error = noise * pitch_error_.Step(kSimulationStep);
    rows_.push_back({std::max(t, stamp),
                     AttitudeEstimate{.t = stamp,
                                      .roll = X.roll + roll_error + noise * tilt_bias_.x(),
                                      .pitch = X.pitch + pitch_error + noise * tilt_bias_.y(),
                                      .yaw = WrapAngle(X.yaw + yaw_error_ + compass_.Of(X.yaw)),
                                      .yaw_rate = 0.0,
                                      .sd_roll = meta.noise.tilt,
                                      .sd_pitch = meta.noise.tilt,
                                      .sd_yaw = 0.0175}});
  }

  /// Of the simulation, from one ping of the DVL to the next.
  [[nodiscard]] int DvlSteps() const {
    return static_cast<int>(std::lround(scene_.dvl_period_s / kSimulationStep));
  }

  void TakeDvl(double t, const SimulatedVehicle& vehicle) {
    const Pose& X = vehicle.pose();
    const Eigen::Vector3d p = X.p_WB + RotationOf(X) * p_BD_;
    if (t > short_gap_end_ && random_.Chance(0.0005))
      short_gap_end_ = t + random_.Uniform(1.0, 5.0);
    const double stamp = dvl_stamp_.StampOf(Seconds(t)).value();
    DvlRow row{.t = stamp, .v_WD_B = {}, .altitude = {}};
    const bool is_in_dropout = troubles_->IsInDropout(t, vehicle);
    if (t > short_gap_end_ && !is_in_dropout) {
      Eigen::Vector3d v = scale_ * (R_DB_ * vehicle.VelocityOf(p_BD_)) + dvl_bias_;
      v = Eigen::Vector3d(v.x() - misalign_ * v.y(), v.y() + misalign_ * v.x(), v.z());
      const double noise = scene_.true_noise * out_.stream.meta.noise.velocity;
      v += DrawVelocityError(noise, 0.5 * noise);
      if (random_.Chance(0.003)) v += DrawVelocityError(0.6, 0.2);
      v += troubles_->FalsePart(t) + bursts_.At(Seconds(t));
      row.v_WD_B = beams_.Velocity(v, SlopesBelow(X), beams_.DrawLost());
      row.altitude = ground_.Depth(p.head<2>()) - p.z() + random_.Normal(0.03);
    }
    rows_.push_back({std::max(t, stamp) + 1e-4, row});
  }

  /// Of the seabed along the beams, which stand 25 deg from the vertical.
  [[nodiscard]] BeamError::Slopes SlopesBelow(const Pose& X) const {
    BeamError::Slopes slopes{};
    const double height = ground_.Depth(X.p_WB.head<2>()) - X.p_WB.z();
    for (int beam = 0; beam < BeamError::kBeams; ++beam) {
      const Eigen::Vector3d beam_W = RotationOf(X) * R_DB_.transpose() * beams_.Direction(beam);
      const Eigen::Vector2d at = (X.p_WB + height / beam_W.z() * beam_W).head<2>();
      const Eigen::Vector2d way = 0.25 * beam_W.head<2>().normalized();
      slopes[static_cast<std::size_t>(beam)] =
          (ground_.Depth(at + way) - ground_.Depth(at - way)) / 0.5;
    }
    return slopes;
  }

  void TakeDepth(double t, const Pose& X) {
    const double noise = scene_.true_noise * random_.Normal(out_.stream.meta.noise.depth);
    const double stamp = depth_stamp_.StampOf(Seconds(t)).value();
    const double depth = X.p_WB.z() + depth_bias_ + noise + pressure_.At(Seconds(t));
    rows_.push_back({std::max(t, stamp) + 2e-4, DepthReading{stamp, depth}});
  }

  /// In the vehicle's frame; 1-sigma ahead and abeam, and below [m/s].
  Eigen::Vector3d DrawVelocityError(double sigma, double sigma_below) {
    const double below = random_.Normal(sigma_below), abeam = random_.Normal(sigma);
    const double ahead = random_.Normal(sigma);
    return {ahead, abeam, below};
  }

  void TakeFix(double t, const SimulatedVehicle& vehicle) {
    const double dt = std::max(t - last_fix_t_, 0.0);
    last_fix_t_ = t;
    const double slow_east = gps_y_.Step(dt), slow_north = gps_x_.Step(dt);
    const double white_east = random_.Normal(0.25), white_north = random_.Normal(0.25);
    const double stamp = gps_stamp_.StampOf(Seconds(t)).value();
    const Eigen::Vector2d p = vehicle.pose().p_WB.head<2>() +
                              Eigen::Vector2d(slow_north, slow_east) +
                              Eigen::Vector2d(white_north, white_east);
    rows_.push_back(
        {std::max(t, stamp) + 3e-4, PositionFix{stamp, p + multipath_.At(Seconds(t)), 0.58}});
  }

  void TakeFrame(double t, const SimulatedVehicle& vehicle) {
    const Pose& X = vehicle.pose();
    const Seconds stamp = camera_stamp_.StampOf(Seconds(t));
    FrameRow row{.arrival = std::max(t, stamp.value()) + random_.Uniform(0.15, 0.35),
                 .frame = {.frame = frames_, .exposure = stamp, .boxes = {}}};
    const Eigen::Vector3d moved = scene_.motion.At(Seconds(t));
    const auto shown = [&](const Eigen::Vector3d& p) {
      return SeenRowByRow(scene_.errors.camera.shutter, camera_, X, vehicle.motion(), p);
    };
    for (std::size_t i = 0; i < ground_.objects().size(); ++i) {
      const auto box = BoxOf(shown(ground_.objects()[i] + moved), ground_.size(i), X, 0.87, 0.95);
      if (!box) continue;
      const int id = scene_.gone + static_cast<int>(i) + 1;
      out_.shown[{frames_, static_cast<int>(row.frame.boxes.size())}] = id;
      row.frame.boxes.push_back(*box);
      const int own = (id - 1) / (scene_.has_twins ? 2 : 1) % scene_.classes;
      const bool is_confused = boxes_.Chance(0.03);
      row.frame.boxes.back().color = std::to_string((own + (is_confused ? 1 : 0)) % scene_.classes);
      ++true_boxes_;
    }
    for (const Eigen::Vector3d& p : ground_.look_alikes()) {
      if (auto box = BoxOf(shown(p), 1.0, X, 0.52, 0.3)) {
        box->color = "0";
        row.frame.boxes.push_back(*box);
      }
    }
    ++frames_;
    frame_rows_.push_back(rows_.size());
    rows_.push_back({row.arrival, row});
  }

  /// The noisy box of a sphere at `p`, `size` times as large as believed, cut by the image's
  /// border; nothing if it is not detected.
  std::optional<Box> BoxOf(const Eigen::Vector3d& p, double size, const Pose& X, double confidence,
                           double hit_share) {
    const double radius = size * out_.stream.meta.opi_radius;
    const Eigen::Matrix3d R_WC = RotationOf(X) * camera_.R_BC;
    const Eigen::Vector3d p_C = R_WC.transpose() * (p - X.p_WB - RotationOf(X) * camera_.p_BC);
    CameraModel wide = camera_;  // whose border cuts nothing
    constexpr int kMargin = 4000;
    wide.width_px += 2 * kMargin, wide.height_px += 2 * kMargin;
    wide.cx += kMargin, wide.cy += kMargin;
    const auto whole = BoxOfSphere(p_C, radius, wide);
    const auto cut = BoxOfSphere(p_C, radius, camera_);
    if (!whole || !cut || p_C.norm() > kFurthest || p_C.z() < 0.5) return std::nullopt;
    const double visible = cut->w * cut->h / (whole->w * whole->h);
    if (visible < 0.25 || !boxes_.Chance(hit_share * std::sqrt(visible))) return std::nullopt;
    Box box = *whole;
    box.confidence =
        std::clamp(confidence - 0.2 * (1.0 - visible) + boxes_.Normal(0.09), 0.1, 0.99);
    const double doubt = scene_.true_noise * (1.0 + 2.0 * (1.0 - box.confidence));
    box.u += boxes_.Normal((2.0 + 0.02 * whole->w) * doubt) - kMargin;
    box.v += boxes_.Normal((2.0 + 0.02 * whole->h) * doubt) - kMargin;
    box.w *= std::max(1.0 + boxes_.Normal(0.05 * doubt), 0.3);
    box.h *= std::max(1.0 + boxes_.Normal(0.05 * doubt), 0.3);
    return Clipped(box);
  }

  [[nodiscard]] std::optional<Box> Clipped(const Box& box) const {
    const CameraModel& camera = out_.stream.meta.camera;
    const double left = std::max(box.u - 0.5 * box.w, 0.0);
    const double right = std::min<double>(box.u + 0.5 * box.w, camera.width_px);
    const double top = std::max(box.v - 0.5 * box.h, 0.0);
    const double bottom = std::min<double>(box.v + 0.5 * box.h, camera.height_px);
    if (right - left < 8.0 || bottom - top < 8.0) return std::nullopt;
    Box cut = box;
    cut.u = 0.5 * (left + right), cut.w = right - left;
    cut.v = 0.5 * (top + bottom), cut.h = bottom - top;
    return cut;
  }

  void AddFalseBoxes() {
    const double share = std::min(scene_.false_share, 0.95);
    const auto count = static_cast<int>(true_boxes_ * share / (1.0 - share));
    for (int i = 0; i < count && !frame_rows_.empty(); ++i) {
      auto& frame = std::get<FrameRow>(rows_[frame_rows_[boxes_.Index(frame_rows_.size())]].row);
      const double w = boxes_.Uniform(40.0, 140.0);
      Box box{.u = boxes_.Uniform(0.0, 640.0),
              .v = boxes_.Uniform(0.0, 360.0),
              .w = w,
              .h = w * boxes_.Uniform(0.7, 1.4),
              .confidence = std::clamp(0.48 + boxes_.Normal(0.1), 0.1, 0.9),
              .color = std::to_string(boxes_.Index(static_cast<unsigned>(scene_.classes)))};
      if (const auto cut = Clipped(box)) frame.frame.boxes.push_back(*cut);
    }
  }

  const StreamScene& scene_;
  const SimulatedGround& ground_;
  SimulatedStream& out_;
  Random random_, boxes_;
  SlowNoise roll_error_{random_, 0.004 * scene_.noise, 30.0};
  SlowNoise pitch_error_{random_, 0.004 * scene_.noise, 30.0};
  SlowNoise yaw_bias_{random_, scene_.yaw_bias_degph* kRadians / 3600.0, 3600.0};
  SlowNoise gps_x_{random_, 0.5 * scene_.true_fix_error, 120.0},
      gps_y_{random_, 0.5 * scene_.true_fix_error, 120.0};
  double yaw_error_ = 0.0, scale_ = 1.0, misalign_ = 0.0, depth_bias_ = 0.0, short_gap_end_ = -1.0,
         last_fix_t_ = 0.0;
  Eigen::Vector3d dvl_bias_ = Eigen::Vector3d::Zero();
  Eigen::Vector2d tilt_bias_ = Eigen::Vector2d::Zero();
  std::optional<DvlTroubles> troubles_;
  // What differs from what the estimator is told; the estimator has the data sheet's.
  CameraModel camera_;
  Eigen::Vector3d p_BD_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d R_DB_ = Eigen::Matrix3d::Identity();
  GyroError gyro_{scene_.errors.fog.gyro};
  CompassError compass_{scene_.errors.imu.compass, Random(scene_.seed, "compass")};
  BeamError beams_{scene_.errors.dvl.beams, 25.0 * kRadians, Random(scene_.seed, "beams")};
  FalseVelocity bursts_{scene_.errors.dvl.bursts, Random(scene_.seed, "bursts")};
  DepthError pressure_{scene_.errors.depth.pressure};
  GpsError multipath_{scene_.errors.gps.multipath, Random(scene_.seed, "multipath")};
  StampError attitude_stamp_{scene_.errors.imu.stamps, Random(scene_.seed, "attitude stamps")};
  StampError dvl_stamp_{scene_.errors.dvl.stamps, Random(scene_.seed, "DVL stamps")};
  StampError depth_stamp_{scene_.errors.depth.stamps, Random(scene_.seed, "depth stamps")};
  StampError gps_stamp_{scene_.errors.gps.stamps, Random(scene_.seed, "GPS stamps")};
  StampError camera_stamp_{scene_.errors.camera.stamps, Random(scene_.seed, "camera stamps")};
  std::vector<Arrival> rows_;
  std::vector<std::size_t> frame_rows_;
  int frames_ = 0, true_boxes_ = 0;
};

}  // namespace

SimulatedStream SimulateStream(const StreamScene& scene) {
  SimulatedStream out;
  const SimulatedGround ground(scene);
  SimulatedVehicle vehicle(scene, ground);
  Recorder recorder(scene, ground, out);
  for (int step = 0; step * kSimulationStep <= scene.duration_s; ++step) {
    vehicle.Step(step * kSimulationStep);
    recorder.Step(step, vehicle);
  }
  recorder.Finish();
  return out;
}

}  // namespace limpet
