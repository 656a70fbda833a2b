// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "estimation/matching/session_matching.hpp"

namespace limpet {

/// Chance, before anything is seen, that a former object is still there.
inline constexpr double kFormerStays = 0.5;

/// Where the former session's frame may lie before any match is seen, as densities of (north,
/// east) [1/m^2] and turn [1/rad].
struct FramePrior {
  /// Prior of a frame known by fixes and compasses: information of (north, east, down, turn).
  [[nodiscard]] static FramePrior Known(const Eigen::Matrix4d& information);
  /// Prior of a frame of which nothing is known but that it is one of the neighbourhood.
  [[nodiscard]] static FramePrior Unknown(double radius_m, Radians turn);
  /// Natural logarithm of the density at this offset.
  [[nodiscard]] double LogDensity(const FrameOffset& offset) const;

 private:
  Eigen::Matrix3d information_ = Eigen::Matrix3d::Zero();  ///< of (north, east, turn)
  double log_peak_ = 0.0;
};

/// How much likelier this session's objects are with the match than if none of them were known, as
/// a natural logarithm: each matched one lies where the former session has it instead of anywhere,
/// and the frame's offset, which the matches themselves decide, costs what they had to choose from
/// (Laplace's approximation). Horizontal: all objects lie on one seabed.
[[nodiscard]] double MatchEvidence(const std::vector<ObjectEstimate>& former,
                                   const std::vector<ObjectEstimate>& now,
                                   const SessionMatch& match, const MatchingParams& params,
                                   const FramePrior& prior);

}  // namespace limpet
