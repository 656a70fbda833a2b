// SPDX-License-Identifier: MIT
#include "estimation/navigation/place_sigmas.hpp"

#include <algorithm>
#include <cmath>

namespace limpet {
namespace {

double MeanSigma(const Eigen::Matrix2d& covariance) {
  return std::sqrt(std::max(0.0, 0.5 * covariance.trace()));
}

}  // namespace

void PlaceSigmas::Note(double t, const Eigen::Vector2d& p_W) {
  times_.push_back(t);
  way_.push_back(places_.empty() ? 0.0 : way_.back() + (p_W - places_.back()).norm());
  places_.push_back(p_W);
}

std::optional<int> PlaceSigmas::NodeBeside(int node) const {
  const auto at = static_cast<std::size_t>(node);
  std::optional<int> nearest;
  double least = kSameGround * kSameGround;
  for (std::size_t i = 0; i < at && way_[i] <= way_[at] - kOtherPass; ++i) {
    const double off = (places_[i] - places_[at]).squaredNorm();
    if (off < least) {
      least = off;
      nearest = static_cast<int>(i);
    }
  }
  return nearest;
}

PlaceSigma PlaceSigmas::Of(int node, const Smoother& smoother) const {
  const std::optional<int> beside = NodeBeside(node);
  if (!beside) {
    const Eigen::Matrix2d S = smoother.PoseCovariance(node).topLeftCorner<2, 2>();
    return {.absolute = MeanSigma(S), .beside = 0.0};
  }
  constexpr Eigen::Index kPose = 6;
  const JointCovariance S = smoother.CovarianceOf({node, *beside}, {});
  const Eigen::Matrix2d here = S.topLeftCorner<2, 2>();
  const Eigen::Matrix2d across = S.block<2, 2>(0, kPose);
  const Eigen::Matrix2d there = S.block<2, 2>(kPose, kPose);
  return {.absolute = MeanSigma(here),
          .beside = MeanSigma(here + there - across - across.transpose())};
}

}  // namespace limpet
