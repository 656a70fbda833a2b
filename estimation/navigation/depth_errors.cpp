// SPDX-License-Identifier: MIT
#include "estimation/navigation/depth_errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "estimation/smoothing/factors/biased_depth_factor.hpp"
#include "estimation/smoothing/factors/border_prior_factor.hpp"
#include "estimation/smoothing/factors/depth_factor.hpp"
#include "estimation/smoothing/factors/slow_errors_factor.hpp"

namespace limpet {
namespace {

constexpr double kPeriod = 600.0;       // [s] for which the bias is one
constexpr double kHour = 3600.0;        // [s]
constexpr double kConstant = 1e-4;      // [m] by which what does not change does
constexpr double kWaves = 0.05;         // [m] by which a vehicle bobs
constexpr double kWavePeriod = 10.0;    // [s] in which that averages out
constexpr double kSurfaceSigmas = 3.5;  // off the surface: no antenna is out of the water there

}  // namespace

void DepthErrors::Begin(double t) {
  if (params_.depth_bias_sigma <= Meters(0.0)) return;
  slot_ = smoother_.AddSensorErrors(Eigen::Vector3d::Zero());
  since_ = t;
  const Eigen::Vector3d sigma(params_.depth_bias_sigma.value(),
                              std::max(params_.surface_depth_sigma.value(), kConstant), 1.0);
  const BorderPriorFactor prior(Eigen::Vector3d::Zero(),
                                sigma.cwiseAbs2().asDiagonal().toDenseMatrix());
  smoother_.AddBorderTerm(*slot_, Term::OnBorder(prior, *slot_));
}

double DepthErrors::Bias() const { return slot_ ? smoother_.BorderAt(*slot_).x() : 0.0; }

int DepthErrors::SlotAt(double t) {
  const double age = t - since_;
  if (age < kPeriod) return *slot_;
  const int next = smoother_.AddSensorErrors(smoother_.BorderAt(*slot_));
  const double change = std::max(params_.depth_bias_drift * std::sqrt(age / kHour), kConstant);
  const SlowErrorsFactor factor(Eigen::Vector3d::Ones(), {change, kConstant, 1.0});
  smoother_.AddBorderTerm(*slot_, Term::OnBorder(factor, std::array{*slot_, next}));
  smoother_.CloseSensorErrors(*slot_);
  slot_ = next;
  since_ = t;
  return next;
}

Term DepthErrors::Measured(double t, Meters depth, Meters sigma) {
  if (!slot_) return Term::OnPose(DepthFactor(depth, sigma));
  return Term::OnObservation(BiasedDepthFactor(depth, sigma, Eigen::Vector3d::UnitX()), SlotAt(t));
}

std::optional<Term> DepthErrors::Surfaced(double t) {
  if (!slot_) return std::nullopt;
  const double z = smoother_.PoseAt(smoother_.graph().node_count() - 1)(kNavZ);
  const double doubt = std::hypot(std::sqrt(std::max(smoother_.Covariance({})(kNavZ, kNavZ), 0.0)),
                                  params_.surface_depth_sigma.value(), kWaves);
  if (std::abs(z - params_.surface_depth.value()) > kSurfaceSigmas * doubt) {
    ++deep_fixes_;
    deep_z_ = z;
    return std::nullopt;
  }
  deep_fixes_ = 0;
  const double since = std::clamp(t - surfaced_t_, 0.1, kWavePeriod);
  surfaced_t_ = t;
  const Meters sigma(kWaves * std::sqrt(kWavePeriod / since));
  return Term::OnObservation(
      BiasedDepthFactor(params_.surface_depth, sigma, -Eigen::Vector3d::UnitY()), SlotAt(t));
}

}  // namespace limpet
