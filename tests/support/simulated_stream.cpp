// SPDX-License-Identifier: MIT
#include "tests/support/simulated_stream.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "limpet/core/random.hpp"
#include "tests/support/sphere_box.hpp"

namespace limpet {
namespace {

constexpr double kStep = 0.05;         // [s] of the simulation: the attitude's period
constexpr double kSpeed = 0.5;         // [m/s]
constexpr double kSurfaceTime = 45.0;  // [s] at the surface, with GPS
constexpr double kSurfaceDepth = 0.2;  // [m] of the body then
constexpr double kFurthest = 6.0;      // [m] an object is seen from
constexpr double kRadians = std::numbers::pi / 180.0;

/// Noise that stays the same for about `tau`: first-order Gauss-Markov.
class SlowNoise {
 public:
  SlowNoise(Random& random, double sigma, double tau)
      : random_(random), sigma_(sigma), tau_(tau), value_(random.Normal(sigma)) {}
  double Step(double dt) {
    const double keep = std::exp(-dt / tau_);
    value_ = keep * value_ + random_.Normal(sigma_ * std::sqrt(1.0 - keep * keep));
    return value_;
  }

 private:
  Random& random_;
  double sigma_, tau_, value_;
};

/// The seabed's depth and what stands on it.
class Ground {
 public:
  explicit Ground(const StreamScene& scene)
      : scene_(scene), random_(scene.place > 0 ? scene.place : scene.seed, "ground") {
    slope_ = {random_.Uniform(-0.03, 0.03), random_.Uniform(-0.03, 0.03)};
    for (double& phase : phases_)
      phase = random_.Uniform(0.0, 6.28);
    while (static_cast<int>(objects_.size()) < scene.objects)
      Place(objects_, 3.5);
    while (static_cast<int>(look_alikes_.size()) < scene.look_alikes)
      Place(look_alikes_, 2.0);
    while (static_cast<int>(objects_.size()) < scene.objects + scene.came)
      Place(objects_, 3.5);
    objects_.erase(objects_.begin(), objects_.begin() + scene.gone);
  }
  [[nodiscard]] double Depth(const Eigen::Vector2d& p) const {
    if (!scene_.is_rough) return 7.5;
    return 9.0 + slope_.dot(p) + 0.5 * std::sin(0.21 * p.x() + phases_[0]) +
           0.4 * std::sin(0.17 * p.y() + phases_[1]) +
           0.15 * std::sin(0.6 * (p.x() + p.y()) + phases_[2]);
  }
  [[nodiscard]] const std::vector<Eigen::Vector3d>& objects() const { return objects_; }
  [[nodiscard]] const std::vector<Eigen::Vector3d>& look_alikes() const { return look_alikes_; }

 private:
  void Place(std::vector<Eigen::Vector3d>& things, double apart) {
    const double reach = 0.85 * scene_.half_size_m;
    Eigen::Vector3d p(random_.Uniform(-reach, reach), random_.Uniform(-reach, reach), 0.0);
    const bool is_twin = scene_.has_twins && &things == &objects_ && things.size() % 2 == 1;
    if (is_twin) {
      const double way = random_.Uniform(0.0, 6.28);
      p = things.back() + 1.1 * Eigen::Vector3d(std::cos(way), std::sin(way), 0.0);
      p.z() = things.back().z();
    } else {
      const auto is_near = [&](const Eigen::Vector3d& q) {
        return (p - q).head<2>().norm() < apart;
      };
      if (std::ranges::any_of(objects_, is_near)) return;
      p.z() = Depth(p.head<2>()) - random_.Uniform(0.4, scene_.is_rough ? 1.2 : 2.0);
    }
    things.push_back(p);
  }
  const StreamScene& scene_;
  Random random_;
  Eigen::Vector2d slope_;
  std::array<double, 3> phases_{};
  std::vector<Eigen::Vector3d> objects_, look_alikes_;
};

/// Where the vehicle really is: it follows the survey's legs, along and across in turn.
class Vehicle {
 public:
  Vehicle(const StreamScene& scene, const Ground& ground)
      : scene_(scene), ground_(ground), random_(scene.seed, "vehicle") {
    X_.p_WB = {random_.Uniform(-1.0, 1.0) - 0.6 * scene.half_size_m, random_.Uniform(-2.0, 2.0),
               kSurfaceDepth};
    X_.yaw = random_.Uniform(-3.1, 3.1);
  }
  void Step(double t) {
    if (waypoints_.empty()) PlanLegs();
    const Eigen::Vector2d off = waypoints_.front() - X_.p_WB.head<2>();
    if (off.norm() < 2.2) {
      waypoints_.erase(waypoints_.begin());
      leg_speed_ = kSpeed + random_.Normal(0.02);  // a current helps or hinders
    }
    const double since =
        scene_.resurface_every_s > 0.0 ? std::fmod(t, scene_.resurface_every_s) : t;
    is_up_ = since < kSurfaceTime;
    const double want_z =
        is_up_ ? kSurfaceDepth : ground_.Depth(X_.p_WB.head<2>()) - scene_.altitude_m;
    const double turn = WrapAngle(std::atan2(off.y(), off.x()) - X_.yaw);
    rate_ += std::clamp(std::clamp(0.6 * turn, -0.3, 0.3) - rate_, -0.01, 0.01);
    const double speed = is_up_ && t < kSurfaceTime ? 0.12 : leg_speed_;
    speed_ += 0.05 * (speed - speed_);
    sink_ += 0.03 * (std::clamp(0.25 * (want_z - X_.p_WB.z()), -0.2, 0.2) - sink_);
    const double c = std::cos(X_.yaw), s = std::sin(X_.yaw), sway = 0.15 * rate_;
    v_W_ = {c * speed_ - s * sway, s * speed_ + c * sway, sink_};
    X_.p_WB += kStep * v_W_;
    X_.yaw = WrapAngle(X_.yaw + kStep * rate_);
    X_.roll += 0.02 * (roll_.Step(kStep) - X_.roll);
    X_.pitch += 0.02 * (pitch_.Step(kStep) - X_.pitch);
  }
  [[nodiscard]] const Pose& pose() const { return X_; }
  [[nodiscard]] double yaw_rate() const { return rate_; }
  [[nodiscard]] bool is_up() const { return is_up_; }
  /// Of the DVL at its lever arm, in body axes.
  [[nodiscard]] Eigen::Vector3d VelocityOf(const Eigen::Vector3d& arm) const {
    const Eigen::Matrix3d R = RotationOf(X_);
    const Eigen::Vector3d w_B = R.transpose() * Eigen::Vector3d(0.0, 0.0, rate_);
    return R.transpose() * v_W_ + w_B.cross(arm);
  }

 private:
  void PlanLegs() {
    const double half = scene_.half_size_m - random_.Uniform(0.0, 1.0);
    const double shift = random_.Uniform(0.0, 1.0) * scene_.leg_spacing_m;
    const double leg_jitter = 0.2 * scene_.leg_spacing_m;
    double end = random_.Chance(0.5) ? 1.0 : -1.0;
    const double side = random_.Chance(0.5) ? 1.0 : -1.0;
    for (double across = -half + shift; across < half; across += scene_.leg_spacing_m, end = -end) {
      const double lane = side * (across + random_.Uniform(-leg_jitter, leg_jitter));
      for (const double along : {end * half, -end * half}) {
        waypoints_.emplace_back(is_across_ ? lane : along, is_across_ ? along : lane);
      }
    }
    is_across_ = !is_across_;
  }
  const StreamScene& scene_;
  const Ground& ground_;
  Random random_;
  SlowNoise roll_{random_, 0.03, 6.0}, pitch_{random_, 0.03, 6.0};
  Pose X_;
  Eigen::Vector3d v_W_ = Eigen::Vector3d::Zero();
  double leg_speed_ = kSpeed;
  double rate_ = 0.0, speed_ = 0.0, sink_ = 0.0;
  bool is_up_ = true, is_across_ = false;
  std::vector<Eigen::Vector2d> waypoints_;
};

/// What the sensors make of it, row by row in order of arrival.
class Recorder {
 public:
  Recorder(const StreamScene& scene, const Ground& ground, SimulatedStream& out)
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
    meta.yaw_bias_sigma = scene.yaw_bias_degph * kRadians / 3600.0;
    yaw_error_ = random_.Normal(1.0 * kRadians);
    scale_ = 1.0 + random_.Normal(meta.dvl_scale_sigma);
    misalign_ = random_.Normal(meta.dvl_misalign_sigma);
    for (int i = 0; i < 3; ++i)
      dvl_bias_(i) = random_.Normal(0.001);
    tilt_bias_ = {random_.Normal(0.002), random_.Normal(0.002)};
    depth_bias_ = random_.Normal(0.01);
    PlanDropouts();
  }

  void Step(int step, const Vehicle& vehicle) {
    const double t = step * kStep;
    TakeAttitude(t, vehicle);
    if (step % 4 == 2) TakeDvl(t, vehicle);
    if (step % 5 == 3) TakeFrame(t, vehicle.pose());
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
  struct Interval {
    double start, end;
  };

  void PlanDropouts() {
    for (int i = 0; i < scene_.long_dropouts; ++i) {
      const double slot = (scene_.duration_s - 500.0) / scene_.long_dropouts;
      const double start = 400.0 + slot * (i + random_.Uniform(0.1, 0.8));
      dropouts_.push_back({start, start + random_.Uniform(25.0, 60.0)});
    }
  }

  void TakeAttitude(double t, const Vehicle& vehicle) {
    const StreamMeta& meta = out_.stream.meta;
    const double drift = yaw_bias_.Step(kStep) * kStep;
    yaw_error_ += drift + random_.Normal(meta.yaw_random_walk * std::sqrt(kStep));
    const Pose& X = vehicle.pose();
    rows_.push_back(
        {t, AttitudeEstimate{.t = t,
                             .roll = X.roll + roll_error_.Step(kStep) + tilt_bias_.x(),
                             .pitch = X.pitch + pitch_error_.Step(kStep) + tilt_bias_.y(),
                             .yaw = WrapAngle(X.yaw + yaw_error_),
                             .yaw_rate = 0.0,
                             .sd_roll = 0.0047,
                             .sd_pitch = 0.0047,
                             .sd_yaw = 0.0175}});
  }

  void TakeDvl(double t, const Vehicle& vehicle) {
    const Eigen::Vector3d arm = out_.stream.meta.dvl_B;
    const Pose& X = vehicle.pose();
    const Eigen::Vector3d p = X.p_WB + RotationOf(X) * arm;
    const auto covers = [t](const Interval& gap) { return t >= gap.start && t < gap.end; };
    if (t > short_gap_end_ && random_.Chance(0.0005))
      short_gap_end_ = t + random_.Uniform(1.0, 5.0);
    DvlRow row{.t = t, .velocity = {}, .altitude = {}};
    if (t > short_gap_end_ && std::ranges::none_of(dropouts_, covers)) {
      Eigen::Vector3d v = scale_ * vehicle.VelocityOf(arm) + dvl_bias_;
      v = Eigen::Vector3d(v.x() - misalign_ * v.y(), v.y() + misalign_ * v.x(), v.z());
      v += Eigen::Vector3d(random_.Normal(0.01), random_.Normal(0.01), random_.Normal(0.005));
      if (random_.Chance(0.003)) {
        v += Eigen::Vector3d(random_.Normal(0.6), random_.Normal(0.6), random_.Normal(0.2));
      }
      row.velocity = v;
      row.altitude = ground_.Depth(p.head<2>()) - p.z() + random_.Normal(0.03);
    }
    rows_.push_back({t + 1e-4, row});
    rows_.push_back({t + 2e-4, DepthRow{t, X.p_WB.z() + depth_bias_ + random_.Normal(0.02)}});
  }

  void TakeFix(double t, const Vehicle& vehicle) {
    const double dt = std::max(t - last_fix_t_, 0.0);
    last_fix_t_ = t;
    const Eigen::Vector2d slow(gps_x_.Step(dt), gps_y_.Step(dt));
    const Eigen::Vector2d white(random_.Normal(0.25), random_.Normal(0.25));
    rows_.push_back({t + 3e-4, GpsRow{t, vehicle.pose().p_WB.head<2>() + slow + white, 0.58}});
  }

  void TakeFrame(double t, const Pose& X) {
    FrameRow row{.arrival = t + random_.Uniform(0.15, 0.35),
                 .frame = {.frame = frames_, .exposure = Seconds(t), .boxes = {}}};
    for (std::size_t i = 0; i < ground_.objects().size(); ++i) {
      const auto box = BoxOf(ground_.objects()[i], X, 0.87, 0.95);
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
      if (auto box = BoxOf(p, X, 0.52, 0.3)) {
        box->color = "0";
        row.frame.boxes.push_back(*box);
      }
    }
    ++frames_;
    frame_rows_.push_back(rows_.size());
    rows_.push_back({row.arrival, row});
  }

  /// The noisy box of a sphere at `p`, cut by the image's border; nothing if it is not detected.
  std::optional<Box> BoxOf(const Eigen::Vector3d& p, const Pose& X, double confidence,
                           double hit_share) {
    const StreamMeta& meta = out_.stream.meta;
    const Eigen::Matrix3d R_WC = RotationOf(X) * meta.camera.R_BC;
    const Eigen::Vector3d p_C = R_WC.transpose() * (p - X.p_WB - RotationOf(X) * meta.camera.p_BC);
    CameraModel wide = meta.camera;  // whose border cuts nothing
    constexpr int kMargin = 4000;
    wide.width_px += 2 * kMargin, wide.height_px += 2 * kMargin;
    wide.cx += kMargin, wide.cy += kMargin;
    const auto whole = BoxOfSphere(p_C, meta.opi_radius, wide);
    const auto cut = BoxOfSphere(p_C, meta.opi_radius, meta.camera);
    if (!whole || !cut || p_C.norm() > kFurthest || p_C.z() < 0.5) return std::nullopt;
    const double visible = cut->w * cut->h / (whole->w * whole->h);
    if (visible < 0.25 || !boxes_.Chance(hit_share * std::sqrt(visible))) return std::nullopt;
    Box box = *whole;
    box.confidence =
        std::clamp(confidence - 0.2 * (1.0 - visible) + boxes_.Normal(0.09), 0.1, 0.99);
    const double doubt = 1.0 + 2.0 * (1.0 - box.confidence);
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
  const Ground& ground_;
  SimulatedStream& out_;
  Random random_, boxes_;
  SlowNoise roll_error_{random_, 0.004, 30.0}, pitch_error_{random_, 0.004, 30.0};
  SlowNoise yaw_bias_{random_, scene_.yaw_bias_degph* kRadians / 3600.0, 3600.0};
  SlowNoise gps_x_{random_, 0.5, 120.0}, gps_y_{random_, 0.5, 120.0};
  double yaw_error_ = 0.0, scale_ = 1.0, misalign_ = 0.0, depth_bias_ = 0.0, short_gap_end_ = -1.0,
         last_fix_t_ = 0.0;
  Eigen::Vector3d dvl_bias_ = Eigen::Vector3d::Zero();
  Eigen::Vector2d tilt_bias_ = Eigen::Vector2d::Zero();
  std::vector<Interval> dropouts_;
  std::vector<Arrival> rows_;
  std::vector<std::size_t> frame_rows_;
  int frames_ = 0, true_boxes_ = 0;
};

}  // namespace

SimulatedStream SimulateStream(const StreamScene& scene) {
  SimulatedStream out;
  const Ground ground(scene);
  Vehicle vehicle(scene, ground);
  Recorder recorder(scene, ground, out);
  for (int step = 0; step * kStep <= scene.duration_s; ++step) {
    vehicle.Step(step * kStep);
    recorder.Step(step, vehicle);
  }
  recorder.Finish();
  return out;
}

}  // namespace limpet
