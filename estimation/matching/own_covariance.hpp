// SPDX-License-Identifier: MIT
// Most of what a session does not know of its objects' places is common to them all: where GPS, the
// first heading and the pressure sensor put its frame. The rest is each object's own.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limpet/objects/object_estimate.hpp"

namespace limpet {

/// The part of each object's covariance that is its own, where only the single covariances are
/// known: what is common is judged by the best known object.
[[nodiscard]] std::vector<ObjectEstimate> WithOwnCovariance(std::vector<ObjectEstimate> objects);

/// Joint covariance (three rows per object) that goes with WithOwnCovariance.
[[nodiscard]] Eigen::MatrixXd JointOfSingles(const std::vector<ObjectEstimate>& objects);

/// A joint covariance of places, split exactly: joint = J frame J' + own, with J the Jacobian of
/// FrameOffset at rest about `pivot_W`.
struct SplitCovariance {
  Eigen::Vector2d pivot_W;
  Eigen::Matrix4d frame;  ///< of (north, east, down [m], turn [rad])
  Eigen::MatrixXd own;    ///< three rows per place
};
[[nodiscard]] SplitCovariance SplitFrom(const std::vector<Eigen::Vector3d>& places_W,
                                        const Eigen::MatrixXd& joint,
                                        const Eigen::Vector2d& pivot_W);

}  // namespace limpet
