// SPDX-License-Identifier: MIT
#include "estimation/navigation/water_model.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace limpet {
namespace {

enum Index { kAhead, kAbeam, kSway, kNorth, kEast };

constexpr double kPause = 1.5;     // [s] without velocity that end a trial
constexpr double kSurprise = 9.0;  // squared innovation over covariance, of two: 1 in 90

double Squared(double x) { return x * x; }

}  // namespace

WaterModel::WaterModel(const WaterParams& params, double arm)
    : params_(params), error_variance_(Squared(params.model_error)) {
  x_ << 0.0, 0.0, arm, 0.0, 0.0;
  State sigma;
  sigma << params.speed_sigma, params.drift_sigma, params.sway_sigma, params.current_sigma,
      params.current_sigma;
  P_ = sigma.cwiseAbs2().asDiagonal();
}

WaterModel::Observation WaterModel::ObservationOf(const Turning& turning) {
  const double c = std::cos(turning.yaw), s = std::sin(turning.yaw);
  Observation H;
  H << 1.0, 0.0, 0.0, c, s,  //
      0.0, 1.0, turning.rate, -s, c;
  return H;
}

double WaterModel::AgeAt(double t) const { return t_ ? std::max(t - *t_, 0.0) : 0.0; }

WaterModel::Covariance WaterModel::CovarianceAt(double t) const {
  const double age = AgeAt(t), keep = std::exp(-age / params_.drift_memory.value());
  Covariance P = P_;
  P.row(kAbeam) *= keep;
  P.col(kAbeam) *= keep;
  P(kAhead, kAhead) += Squared(params_.speed_walk) * age;
  P(kAbeam, kAbeam) += (1.0 - keep * keep) * Squared(params_.drift_sigma);
  P(kSway, kSway) += Squared(params_.sway_walk) * age;
  P(kNorth, kNorth) += Squared(params_.current_walk) * age;
  P(kEast, kEast) += Squared(params_.current_walk) * age;
  return P;
}

void WaterModel::Add(double t, const Eigen::Vector2d& v_H, const Turning& turning) {
  const double dt = AgeAt(t);
  P_ = CovarianceAt(t);
  x_(kAbeam) *= std::exp(-dt / params_.drift_memory.value());
  const Observation H = ObservationOf(turning);
  const Eigen::Vector2d innovation = v_H - H * x_;
  const Eigen::Matrix2d R = Squared(params_.velocity_noise) * Eigen::Matrix2d::Identity();
  Eigen::Matrix2d S = H * P_ * H.transpose() + R;
  if (innovation.dot(S.inverse() * innovation) > kSurprise) {
    // The vehicle changed its way through the water; the water has no thrusters.
    P_(kAhead, kAhead) += Squared(innovation.x());
    P_(kAbeam, kAbeam) += Squared(innovation.y());
    S = H * P_ * H.transpose() + R;
  }
  const Eigen::Matrix<double, 5, 2> K = P_ * H.transpose() * S.inverse();
  x_ += K * innovation;
  const Covariance rest = Covariance::Identity() - K * H;
  P_ = (rest * P_ * rest.transpose() + K * R * K.transpose()).eval();
  Try(t, v_H, H);
  const double share = t_ ? std::min(dt, 1.0) / params_.usual_memory.value() : 1.0;
  const double off_usual = x_(kAhead) - usual_;
  spread_ += t_ ? share * (Squared(off_usual) - spread_) : 0.0;
  usual_ += share * off_usual;
  t_ = t;
}

void WaterModel::Try(double t, const Eigen::Vector2d& v_H, const Observation& H) {
  if (!trial_ || t - trial_->last > kPause) {
    trial_ = Trial{.since = t, .last = t, .x = x_};
    return;
  }
  trial_->last = t;
  const Eigen::Matrix2d R_HW = H.block<2, 2>(0, kNorth);
  trial_->off += R_HW.transpose() * (v_H - H * trial_->x);
  ++trial_->count;
  const double length = t - trial_->since;
  if (length < params_.trial.value()) return;
  const double variance = 0.5 * (trial_->off / trial_->count).squaredNorm();
  const double share = length / params_.trial_memory.value();
  error_variance_ += share * (std::min(variance, Squared(params_.worst_trial)) - error_variance_);
  error_variance_ = std::max(error_variance_, Squared(params_.model_error));
  trial_ = Trial{.since = t, .last = t, .x = x_};
}

double WaterModel::ManeuverVariance(double seconds) const {
  const double reached = Squared(params_.maneuver_mps2 * seconds);
  return std::min(Squared(params_.maneuver_share) * spread_, reached);
}

double WaterModel::SpeedAt(double t) const {
  const double off = x_(kAhead) - usual_;
  const double target = usual_ + std::clamp(off, -params_.usual_band, params_.usual_band);
  return target + std::exp(-AgeAt(t) / params_.excursion_memory.value()) * (x_(kAhead) - target);
}

Eigen::Vector2d WaterModel::VelocityAt(double t, const Turning& turning) const {
  State x = x_;
  x(kAhead) = SpeedAt(t);
  x(kAbeam) *= std::exp(-AgeAt(t) / params_.drift_memory.value());
  return Eigen::Rotation2Dd(turning.yaw) * (ObservationOf(turning) * x);
}

double WaterModel::VarianceAt(double t, const Turning& turning) const {
  const Observation H = ObservationOf(turning);
  const Eigen::Matrix2d of_state = H * CovarianceAt(t) * H.transpose();
  return 0.5 * of_state.trace() + error_variance_ + ManeuverVariance(AgeAt(t)) +
         0.25 * Squared(x_(kAhead) - SpeedAt(t));
}

Eigen::Matrix3d WaterModel::BridgeCovariance(double t) const {
  const Covariance P = CovarianceAt(t);
  Eigen::Matrix3d bridge;
  bridge.topLeftCorner<2, 2>() = P.block<2, 2>(kNorth, kNorth);
  bridge.topRightCorner<2, 1>() = P.block<2, 1>(kNorth, kAhead);
  bridge.bottomLeftCorner<1, 2>() = P.block<1, 2>(kAhead, kNorth);
  constexpr double kLong = 60.0;  // [s] a bridge may be
  bridge(2, 2) =
      P(kAhead, kAhead) + ManeuverVariance(kLong) + 0.25 * Squared(x_(kAhead) - SpeedAt(t));
  // Speed abeam turns with the vehicle; as a part of the current it is nowhere less likely.
  const double besides = error_variance_ + P(kAbeam, kAbeam);
  bridge.diagonal().head<2>().array() += besides;
  return bridge;
}

Eigen::Vector3d WaterModel::BridgeChange(double seconds) const {
  return std::sqrt(seconds) *
         Eigen::Vector3d(params_.current_walk, params_.current_walk, params_.speed_walk);
}

Eigen::Vector2d WaterModel::EndVariance(double seconds) const {
  return Eigen::Vector2d(ManeuverVariance(seconds), 0.0).array() + 0.3 * error_variance_;
}

WaterState WaterModel::StateAt(double t) const {
  const Covariance P = CovarianceAt(t);
  WaterState state{.current_W = {x_(kNorth), x_(kEast)}, .speed = SpeedAt(t)};
  state.sd_current = {std::sqrt(P(kNorth, kNorth)), std::sqrt(P(kEast, kEast))};
  state.sd_speed = std::sqrt(P(kAhead, kAhead));
  return state;
}

}  // namespace limpet
