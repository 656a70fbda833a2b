// SPDX-License-Identifier: MIT
#include "estimation/matching/match_evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/LU>

namespace limpet {
namespace {

constexpr double kBorder_m = 5.0;           // seen around the outermost objects
constexpr std::array kHorizontal{0, 1, 3};  // of (north, east, down, turn)

double LogOf2Pi() { return std::log(2.0 * std::numbers::pi); }

/// Density of objects like this one where nothing is known of them [1/m^2].
double DensityOf(const std::string& color, const std::vector<ObjectEstimate>& now) {
  Eigen::Array2d low = Eigen::Array2d::Constant(1e300), high = -low;
  double alike = 0.0;
  for (const ObjectEstimate& object : now) {
    low = low.min(object.p_W.head<2>().array()), high = high.max(object.p_W.head<2>().array());
    alike += object.color == color ? 1.0 : 0.0;
  }
  return std::max(alike, 1.0) / (high - low + 2.0 * kBorder_m).prod();
}

}  // namespace

FramePrior FramePrior::Known(const Eigen::Matrix4d& information) {
  FramePrior prior;
  const Eigen::Matrix4d covariance = information.inverse();
  prior.information_ = covariance(kHorizontal, kHorizontal).inverse();
  prior.log_peak_ = 0.5 * std::log(prior.information_.determinant()) - 1.5 * LogOf2Pi();
  return prior;
}

FramePrior FramePrior::Unknown(double radius_m, Radians turn) {
  FramePrior prior;
  prior.log_peak_ = -std::log(std::numbers::pi * radius_m * radius_m * 2.0 * turn.value());
  return prior;
}

double FramePrior::LogDensity(const FrameOffset& offset) const {
  const Eigen::Vector3d off(offset.shift_W.x(), offset.shift_W.y(), offset.turn);
  return log_peak_ - 0.5 * off.dot(information_ * off);
}

double MatchEvidence(const std::vector<ObjectEstimate>& former,
                     const std::vector<ObjectEstimate>& now, const SessionMatch& match,
                     const MatchingParams& params, const FramePrior& prior) {
  const Eigen::Matrix3d frame = match.offset_cov(kHorizontal, kHorizontal);
  double evidence = prior.LogDensity(match.offset) + 1.5 * LogOf2Pi() +
                    0.5 * std::log(std::max(frame.determinant(), 1e-300));
  for (std::size_t i = 0; i < former.size(); ++i) {
    if (!match.now_of_former[i]) continue;
    const ObjectEstimate& there = now[static_cast<std::size_t>(*match.now_of_former[i])];
    const Eigen::Vector2d off = (there.p_W - match.offset.Apply(former[i].p_W)).head<2>();
    const Eigen::Matrix2d S = params.PairCovariance(former[i], there).topLeftCorner<2, 2>();
    evidence += std::log(kFormerStays / DensityOf(there.color, now)) - LogOf2Pi() -
                0.5 * std::log(S.determinant()) - 0.5 * off.dot(S.inverse() * off) -
                0.5 * params.ColorCost(former[i], there);
  }
  return evidence;
}

}  // namespace limpet
