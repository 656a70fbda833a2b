// SPDX-License-Identifier: MIT
#include "tests/support/simulated_survey.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

namespace limpet {
namespace {

constexpr double kStep = kSimulationStep;
constexpr double kSpeed = 0.5;           // [m/s]
constexpr double kSurfaceTime = 45.0;    // [s] at the surface, with GPS
constexpr double kSurfaceDepth = 0.2;    // [m] of the body then
constexpr double kReached = 2.2;         // [m] from a waypoint
constexpr double kSwayPerRate = 0.15;    // [m/s per rad/s]
constexpr double kUnrest = 0.03;         // of the current: what is not the tide's
constexpr double kUnrestMemory = 600.0;  // [s]
constexpr double kPi = std::numbers::pi;
constexpr double kLongestLead = 15.0;  // [s] of a dropout before its turn

}  // namespace

double SlowNoise::Step(double dt) {
  const double keep = std::exp(-dt / tau_);
  value_ = keep * value_ + random_.Normal(sigma_ * std::sqrt(1.0 - keep * keep));
  return value_;
}

SimulatedGround::SimulatedGround(const StreamScene& scene)
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
  Random sizes(scene.place > 0 ? scene.place : scene.seed, "sizes");
  std::ranges::generate_n(std::back_inserter(sizes_), std::ssize(objects_),
                          [&] { return std::pow(scene.size_spread, sizes.Uniform(-1.0, 1.0)); });
  objects_.erase(objects_.begin(), objects_.begin() + scene.gone);
  sizes_.erase(sizes_.begin(), sizes_.begin() + scene.gone);
}

double SimulatedGround::Depth(const Eigen::Vector2d& p) const {
  if (!scene_.is_rough) return 7.5;
  return 9.0 + slope_.dot(p) + 0.5 * std::sin(0.21 * p.x() + phases_[0]) +
         0.4 * std::sin(0.17 * p.y() + phases_[1]) +
         0.15 * std::sin(0.6 * (p.x() + p.y()) + phases_[2]);
}

void SimulatedGround::Place(std::vector<Eigen::Vector3d>& things, double apart) {
  const double reach = 0.85 * scene_.half_size_m;
  const double east = random_.Uniform(-reach, reach), north = random_.Uniform(-reach, reach);
  Eigen::Vector3d p(north, east, 0.0);
  const bool is_twin = scene_.has_twins && &things == &objects_ && things.size() % 2 == 1;
  if (is_twin) {
    const double way = random_.Uniform(0.0, 6.28);
    p = things.back() + 1.1 * Eigen::Vector3d(std::cos(way), std::sin(way), 0.0);
    p.z() = things.back().z();
  } else {
    const auto is_near = [&](const Eigen::Vector3d& q) { return (p - q).head<2>().norm() < apart; };
    if (std::ranges::any_of(objects_, is_near)) return;
    p.z() = Depth(p.head<2>()) - random_.Uniform(0.4, scene_.is_rough ? 1.2 : 2.0);
  }
  things.push_back(p);
}

TidalCurrent CurrentOf(const StreamScene& scene) {
  Random random(scene.seed, "current");
  const double speed = random.Uniform(0.0, scene.current_mps);
  const double way = random.Uniform(-kPi, kPi);
  TidalCurrentParams params;
  params.tide_swing = Radians(random.Uniform(0.2, 1.0));
  params.tide_period = Seconds(random.Uniform(3600.0, 7200.0));
  params.tide_share = 0.1;
  params.unrest_share = kUnrest;
  params.unrest = Seconds(kUnrestMemory);
  return {scene.tide.value_or(params), {speed * std::cos(way), speed * std::sin(way)}, random};
}

SimulatedVehicle::SimulatedVehicle(const StreamScene& scene, const SimulatedGround& ground)
    : scene_(scene),
      ground_(ground),
      random_(scene.seed, "vehicle"),
      current_(CurrentOf(scene)),
      leg_speed_(kSpeed) {
  X_.p_WB = {random_.Uniform(-1.0, 1.0) - 0.6 * scene.half_size_m, random_.Uniform(-2.0, 2.0),
             kSurfaceDepth};
  X_.yaw = random_.Uniform(-3.1, 3.1);
}

void SimulatedVehicle::Step(double t) {
  if (waypoints_.empty()) PlanLegs();
  const Eigen::Vector2d off = waypoints_.front() - X_.p_WB.head<2>();
  if (off.norm() < kReached) {
    waypoints_.erase(waypoints_.begin());
    leg_speed_ = kSpeed + random_.Normal(scene_.leg_speed_sd_mps);
  }
  const double since = scene_.resurface_every_s > 0.0 ? std::fmod(t, scene_.resurface_every_s) : t;
  is_up_ = since < kSurfaceTime;
  const double want_z =
      is_up_ ? kSurfaceDepth : ground_.Depth(X_.p_WB.head<2>()) - scene_.altitude_m;
  const double turn = WrapAngle(std::atan2(off.y(), off.x()) - X_.yaw);
  rate_ += std::clamp(std::clamp(0.6 * turn, -0.3, 0.3) - rate_, -0.01, 0.01);
  const bool stands = scene_.standing && t >= scene_.standing->low && t < scene_.standing->high;
  const double speed = stands ? 0.0 : is_up_ && t < kSurfaceTime ? 0.12 : leg_speed_;
  speed_ += 0.05 * (speed - speed_);
  sink_ += 0.03 * (std::clamp(0.25 * (want_z - X_.p_WB.z()), -0.2, 0.2) - sink_);
  const double c = std::cos(X_.yaw), s = std::sin(X_.yaw), sway = kSwayPerRate * rate_;
  v_W_ = {c * speed_ - s * sway, s * speed_ + c * sway, sink_};
  v_W_.head<2>() += current_.At(Seconds(t), X_.p_WB.z());
  X_.p_WB += kStep * v_W_;
  X_.yaw = WrapAngle(X_.yaw + kStep * rate_);
  X_.roll += 0.02 * (roll_.Step(kStep) - X_.roll);
  X_.pitch += 0.02 * (pitch_.Step(kStep) - X_.pitch);
}

double SimulatedVehicle::UntilTurn() const {
  if (waypoints_.empty()) return std::numeric_limits<double>::infinity();
  return ((waypoints_.front() - X_.p_WB.head<2>()).norm() - kReached) / kSpeed;
}

BodyMotion SimulatedVehicle::motion() const {
  const Eigen::Matrix3d R = RotationOf(X_);
  return {.v_B = R.transpose() * v_W_, .omega_B = R.transpose() * Eigen::Vector3d(0, 0, rate_)};
}

Eigen::Vector3d SimulatedVehicle::VelocityOf(const Eigen::Vector3d& arm) const {
  const Eigen::Matrix3d R = RotationOf(X_);
  const Eigen::Vector3d w_B = R.transpose() * Eigen::Vector3d(0.0, 0.0, rate_);
  return R.transpose() * v_W_ + w_B.cross(arm);
}

void SimulatedVehicle::PlanLegs() {
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

DvlTroubles::DvlTroubles(const StreamScene& scene, Random& dropouts)
    : random_(scene.seed, "troubles") {
  if (scene.has_turns_in_dropouts) turn_lead_ = random_.Uniform(1.0, kLongestLead);
  for (int i = 0; i < scene.long_dropouts; ++i) {
    const double slot = (scene.duration_s - 500.0) / scene.long_dropouts;
    const double start = 400.0 + slot * (i + dropouts.Uniform(0.1, 0.8));
    const double length = dropouts.Uniform(scene.shortest_dropout_s, scene.longest_dropout_s);
    dropouts_.push_back({start, start + length});
  }
  for (int i = 0; i < scene.velocity_bursts; ++i) {
    const double slot = (scene.duration_s - 200.0) / scene.velocity_bursts;
    const double start = 150.0 + slot * (i + random_.Uniform(0.0, 0.9));
    const Eigen::Vector2d off = Eigen::Rotation2Dd(random_.Uniform(-kPi, kPi)) *
                                Eigen::Vector2d(random_.Uniform(0.25, 1.0), 0.0);
    bursts_.push_back({.when = {start, start + random_.Uniform(2.0, 4.0)},
                       .off = {off.x(), off.y(), random_.Normal(0.1)}});
  }
}

bool DvlTroubles::IsInDropout(double t, const SimulatedVehicle& vehicle) {
  if (dropouts_.empty() || t < dropouts_.front().start) return false;
  Interval& now = dropouts_.front();
  if (turn_lead_ && !is_turn_due_) {
    if (vehicle.UntilTurn() > *turn_lead_) return false;
    now = {.start = t, .end = t + now.end - now.start};
    is_turn_due_ = true;
  }
  if (t < now.end) return true;
  dropouts_.erase(dropouts_.begin());
  is_turn_due_ = false;
  if (turn_lead_) turn_lead_ = random_.Uniform(1.0, kLongestLead);
  return false;
}

Eigen::Vector3d DvlTroubles::FalsePart(double t) const {
  for (const Burst& burst : bursts_)
    if (t >= burst.when.start && t < burst.when.end) return burst.off;
  return Eigen::Vector3d::Zero();
}

}  // namespace limpet
