// SPDX-License-Identifier: MIT
#include "estimation/navigation/water_model.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace limpet {
namespace {

enum Index { kAhead, kAbeam, kSwayPerRate, kNorth, kEast, kDriven };

constexpr double kPause = 1.5;     // [s] without velocity that end a trial
constexpr double kUnderWay = 0.2;  // share of speed_sigma from which a vehicle is under way
constexpr double kStanding = 0.5;  // share of its usual speed below which a vehicle stands
constexpr double kChange = 0.05;   // [m/s] of what the thrusters make: another stretch of a bridge
constexpr double kLongStretch = 10.0, kShortStretch = 5.0;  // [s]
constexpr double kBridgeNoise = 0.01;                       // [m/sqrt(s)]
constexpr double kSurprisingVelocity = 9.0;  // squared innovation over covariance, of two: 1 in 90

constexpr double kStopped = 0.3, kGoing = 0.7;  // shares of the usual speed

double Squared(double x) { return x * x; }

}  // namespace

WaterModel::WaterModel(const WaterParams& params, double arm)
    : params_(params), arm_(arm), error_variance_(Squared(params.model_error)) {
  Begin(false);
}

void WaterModel::Begin(bool is_driven) {
  x_ << 0.0, 0.0, arm_, 0.0, 0.0, 1.0;
  P_ = FirstCovariance(is_driven);
  trial_.reset();
}

WaterModel::Covariance WaterModel::FirstCovariance(bool is_driven) const {
  State sigma;
  sigma << (is_driven ? params_.beside_driven : params_.speed_sigma),
      (is_driven ? params_.beside_driven : params_.drift_sigma), params_.sway_sigma,
      params_.current_sigma, params_.current_sigma, params_.driven_sigma;
  return sigma.cwiseAbs2().asDiagonal();
}

WaterModel::Observation WaterModel::ObservationOf(const Conduct& conduct) {
  const double c = std::cos(conduct.yaw), s = std::sin(conduct.yaw);
  Observation H;
  const Eigen::Vector2d driven = conduct.driven_B.value_or(Eigen::Vector2d::Zero());
  H << 1.0, 0.0, 0.0, c, s, driven.x(),  //
      0.0, 1.0, conduct.rate, -s, c, driven.y();
  return H;
}

double WaterModel::AgeAt(double t) const { return t_ ? std::max(t - *t_, 0.0) : 0.0; }

WaterModel::Covariance WaterModel::CovarianceAt(double t) const {
  const double age = AgeAt(t);
  Covariance P = P_;
  const auto forget = [&P](Index i, double keep, double sigma) {
    P.row(i) *= keep;
    P.col(i) *= keep;
    P(i, i) += (1.0 - keep * keep) * Squared(sigma);
  };
  if (driven_B_) {
    forget(kAhead, KeepAt(t), params_.beside_driven);
    forget(kAbeam, KeepAt(t), params_.beside_driven);
    P(kDriven, kDriven) += Squared(params_.driven_walk) * age;
  } else {
    forget(kAbeam, KeepAt(t), params_.drift_sigma);
    P(kAhead, kAhead) += Squared(params_.speed_walk) * age;
  }
  P(kSwayPerRate, kSwayPerRate) += Squared(params_.sway_walk) * age;
  P(kNorth, kNorth) += Squared(params_.current_walk) * age;
  P(kEast, kEast) += Squared(params_.current_walk) * age;
  return P;
}

WaterModel::Covariance WaterModel::CovarianceAt(double t, const Conduct& conduct) const {
  return t_ || !conduct.driven_B ? CovarianceAt(t) : FirstCovariance(true);
}

void WaterModel::Add(double t, const Eigen::Vector2d& v_H, const Conduct& conduct) {
  if (conduct.driven_B && !driven_B_)
    Begin(true);  // else the speed was taken for the vehicle's own
  P_ = CovarianceAt(t);
  const Eigen::Vector2d change = DrivenVariance(conduct);
  P_(kAhead, kAhead) += change.x();
  P_(kAbeam, kAbeam) += change.y();
  x_(kAhead) *= driven_B_ ? KeepAt(t) : 1.0;
  x_(kAbeam) *= KeepAt(t);
  const Observation H = ObservationOf(conduct);
  const Eigen::Vector2d innovation = v_H - H * x_;
  const Eigen::Matrix2d R = Squared(params_.velocity_noise) * Eigen::Matrix2d::Identity();
  Eigen::Matrix2d S = H * P_ * H.transpose() + R;
  if (!conduct.driven_B && innovation.dot(S.inverse() * innovation) > kSurprisingVelocity) {
    // The vehicle changed its way through the water; the water has no thrusters.
    P_(kAhead, kAhead) += Squared(innovation.x());
    P_(kAbeam, kAbeam) += Squared(innovation.y());
    S = H * P_ * H.transpose() + R;
  }
  const Eigen::Matrix<double, 6, 2> K = P_ * H.transpose() * S.inverse();
  x_ += K * innovation;
  const Covariance rest = Covariance::Identity() - K * H;
  P_ = (rest * P_ * rest.transpose() + K * R * K.transpose()).eval();
  Try(t, v_H, H);
  LearnHabit(t);
  t_ = t;
  driven_B_ = conduct.driven_B;
}

void WaterModel::LearnHabit(double t) {
  if (!departed_) departed_ = t;
  // No longer than it has been under way.
  const double under_way = t - *departed_;
  const double memory = std::clamp(under_way, 1.0, params_.usual_memory.value());
  const double share = t_ ? std::min(AgeAt(t), 1.0) / memory : 1.0;
  const double off_usual = x_(kAhead) - usual_;
  spread_ += t_ ? share * (Squared(off_usual) - spread_) : 0.0;
  usual_ += share * off_usual;
  if (under_way > 0.5 * params_.departure.value()) {
    CountStops(t_ ? std::min(AgeAt(t), 1.0) : 0.0);
    fastest_ = std::max(fastest_, std::abs(usual_));
  }
}

void WaterModel::CountStops(double seconds) {
  const double speed = std::abs(x_(kAhead));
  const bool has_stopped = is_going_ && speed < kStopped * fastest_;
  stops_ += has_stopped ? 1.0 : 0.0;
  is_going_ = !has_stopped && (is_going_ || speed > kGoing * fastest_);
  under_way_ += is_going_ ? seconds : 0.0;
}

double WaterModel::UntoldSpeed() const {
  if (driven_B_) return 0.0;
  if (!t_) return params_.speed_sigma;
  const bool is_departing = *t_ - *departed_ < params_.departure.value();
  const bool has_gone = fastest_ > kUnderWay * params_.speed_sigma;
  const double cruise =
      is_departing || !has_gone ? std::max(params_.speed_sigma, fastest_) : fastest_;
  const double usual = std::abs(usual_);
  return usual < kStanding * cruise ? cruise - usual : 0.0;
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
  if (driven_B_ || !t_) return 0.0;
  const double reached = Squared(params_.maneuver_mps2 * seconds);
  const double told = Squared(params_.maneuver_share) * spread_ + Squared(UntoldSpeed());
  return std::min(told, reached);
}

double WaterModel::KeepAt(double t) const {
  return std::exp(-AgeAt(t) / (driven_B_ ? params_.beside_memory : params_.drift_memory).value());
}

double WaterModel::SpeedAt(double t) const {
  if (driven_B_) return KeepAt(t) * x_(kAhead);
  if (UntoldSpeed() > 0.0) return x_(kAhead);  // there is no habit to fall back to
  const double off = x_(kAhead) - usual_;
  const double target = usual_ + std::clamp(off, -params_.usual_band, params_.usual_band);
  return target + std::exp(-AgeAt(t) / params_.excursion_memory.value()) * (x_(kAhead) - target);
}

Eigen::Vector2d WaterModel::VelocityAt(double t, const Conduct& conduct) const {
  State x = x_;
  x(kAhead) = SpeedAt(t);
  x(kAbeam) *= KeepAt(t);
  return Eigen::Rotation2Dd(conduct.yaw) * (ObservationOf(conduct) * x);
}

double WaterModel::VarianceAt(double t, const Conduct& conduct) const {
  const Observation H = ObservationOf(conduct);
  const Eigen::Matrix2d of_state = H * CovarianceAt(t, conduct) * H.transpose();
  return 0.5 * of_state.trace() + error_variance_ + ManeuverVariance(AgeAt(t)) +
         0.25 * Squared(x_(kAhead) - SpeedAt(t)) + 0.5 * DrivenVariance(conduct).sum();
}

Eigen::Vector2d WaterModel::DrivenVariance(const Conduct& conduct) const {
  if (!conduct.driven_B || (t_ && !driven_B_)) return Eigen::Vector2d::Zero();
  const Eigen::Vector2d before = driven_B_.value_or(Eigen::Vector2d::Zero());
  return (params_.driven_change * (*conduct.driven_B - before)).cwiseAbs2();
}

double WaterModel::UntrueShare() const {
  return Squared(params_.driven_change) + P_(kDriven, kDriven);
}

Eigen::Matrix3d WaterModel::BridgeCovariance(double t, const Conduct& conduct) const {
  const Covariance P = CovarianceAt(t, conduct);
  Eigen::Matrix<double, 3, 6> parts = Eigen::Matrix<double, 3, 6>::Zero();
  parts(0, kNorth) = parts(1, kEast) = parts(2, kAhead) = 1.0;
  parts(2, kDriven) = conduct.driven_B.value_or(Eigen::Vector2d::Zero()).x();
  Eigen::Matrix3d bridge = parts * P * parts.transpose();
  constexpr double kLong = 60.0;  // [s] a bridge may be
  bridge(2, 2) += ManeuverVariance(kLong) + 0.25 * Squared(x_(kAhead) - SpeedAt(t)) +
                  DrivenVariance(conduct).x();
  // Speed abeam turns with the vehicle; as a part of the current it is nowhere less likely.
  const double besides = error_variance_ + P(kAbeam, kAbeam);
  bridge.diagonal().head<2>().array() += besides;
  return bridge;
}

// Commands tell how the speed changes, but for a share; without them one that stands may start.
BridgeDrift WaterModel::BridgeChange(double seconds, const Conduct& from, const Conduct& to) const {
  BridgeDrift drift{.current_change = params_.current_walk * std::sqrt(seconds)};
  double variance = Squared(params_.speed_walk) * seconds;
  if (to.driven_B) {
    const double before = from.driven_B.value_or(Eigen::Vector2d::Zero()).x();
    variance += UntrueShare() * Squared(to.driven_B->x() - before);
  } else if (const double untold = UntoldSpeed(); untold > 0.0) {
    drift.speed_kept = std::sqrt(1.0 - LostIn(seconds));
    variance += LostIn(seconds) * Squared(untold);
  }
  drift.speed_change = std::sqrt(variance);
  return drift;
}

double WaterModel::BridgeStretch(const Conduct& from, const Conduct& to) const {
  if (!to.driven_B) return UntoldSpeed() > 0.0 ? kShortStretch : kLongStretch;
  const double before = from.driven_B.value_or(Eigen::Vector2d::Zero()).x();
  return std::abs(to.driven_B->x() - before) > kChange ? kShortStretch : kLongStretch;
}

// What changes within a stretch, as if it came at any time of it.
double WaterModel::BridgeNoise(const Conduct& conduct) const {
  const double untold = conduct.driven_B ? 0.0 : UntoldSpeed();
  return std::hypot(kBridgeNoise, untold * std::sqrt(LostIn(kShortStretch) * kShortStretch / 3.0));
}

double WaterModel::LostIn(double seconds) const {
  return 1.0 - std::exp(-2.0 * seconds / params_.conduct_memory.value());
}

Eigen::Vector2d WaterModel::EndVariance(double seconds, const Conduct& conduct) const {
  const double untold = UntoldSpeed();
  const double ahead =
      untold > 0.0 ? Squared(untold) * LostIn(kShortStretch) / 3.0 : ManeuverVariance(seconds);
  Eigen::Vector2d variance = Eigen::Vector2d(ahead, 0.0).array() + 0.3 * error_variance_;
  if (driven_B_ && conduct.driven_B)
    variance += UntrueShare() * (*conduct.driven_B - *driven_B_).cwiseAbs2();
  return variance;
}

WaterState WaterModel::StateAt(double t, const Conduct& conduct) const {
  const Covariance P = CovarianceAt(t);
  const double driven = conduct.driven_B.value_or(Eigen::Vector2d::Zero()).x();
  Eigen::Matrix<double, 1, 6> ahead = Eigen::Matrix<double, 1, 6>::Zero();
  ahead(kAhead) = 1.0;
  ahead(kDriven) = driven;
  WaterState state{.current_W = {x_(kNorth), x_(kEast)},
                   .speed = SpeedAt(t) + x_(kDriven) * driven};
  state.sd_current_W = {std::sqrt(P(kNorth, kNorth)), std::sqrt(P(kEast, kEast))};
  state.sd_speed = std::sqrt((ahead * P).dot(ahead));
  return state;
}

}  // namespace limpet
