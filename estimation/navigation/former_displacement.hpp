// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "estimation/matching/session_matching.hpp"

namespace limpet {

/// Per former object that `match` has found: the chance that it stands where it stood, rather than
/// that it was moved, or that it is gone and another one came; 1 for the others. By how far it is
/// from where the offset puts it that the other matches give, with what is unknown of both places
/// and of that offset; over the ground and in depth, where what all objects have in common is the
/// offset's (another tide, another zero of the depth sensor). Objects that seem to have moved are
/// taken out of the fit of `match.offset`, one after the other. Objects with covariances of their
/// own, without what is common to their sessions; `prior`: information of the offset (north, east,
/// down, turn).
[[nodiscard]] std::vector<double> ChancesOfSamePlace(const std::vector<ObjectEstimate>& former,
                                                     const std::vector<ObjectEstimate>& now,
                                                     const MatchingParams& params,
                                                     const Eigen::Matrix4d& prior,
                                                     SessionMatch& match);

}  // namespace limpet
