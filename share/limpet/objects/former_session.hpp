// SPDX-License-Identifier: MIT
// What a former session knew of its objects, in that session's frame.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limpet/objects/object_estimate.hpp"

namespace limpet {

/// An object that a former session found, as far as a later one goes by it: where it was, and how
/// surely. What that session decided of it (OpiBelief) is none of it: the status was about the
/// session before, and a later one comes to its own.
struct FormerObject {
  int id = 0;
  ObjectEstimate object;
  /// Lambda of the former session: ln P(looks | present) / P(looks | absent); 0 where it counted no
  /// looks.
  double log_likelihood_ratio = 0.0;
  int looks = 0;
};

/// All objects that a former session found, and how their places go together.
struct FormerSession {
  std::vector<FormerObject> objects;
  /// Joint covariance of `objects` [m^2], three rows each; empty if only their own are known.
  Eigen::MatrixXd joint_cov_W{};
};

[[nodiscard]] inline std::vector<ObjectEstimate> EstimatesOf(
    const std::vector<FormerObject>& former) {
  std::vector<ObjectEstimate> estimates;
  estimates.reserve(former.size());
  for (const FormerObject& object : former)
    estimates.push_back(object.object);
  return estimates;
}

}  // namespace limpet
