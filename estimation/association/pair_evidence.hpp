// SPDX-License-Identifier: MIT
// What two rows of boxes say, beside their places, of whether they show one object: -2 ln of the
// likelihood that they do over that they do not.
#pragma once

#include <Eigen/Core>

#include "estimation/association/tracked_object.hpp"

namespace limpet {

/// Beyond this, nothing that is known of places counts against it.
inline constexpr double kTwoObjectsCost = 24.0;

/// Cost by the classes that the boxes were given, of which a `confused` share is wrong. At best 0:
/// how common a class is, is not known.
[[nodiscard]] double ClassCost(const TrackedObject& a, const TrackedObject& b, double confused);

/// Cost by the frames that show both at one time. Were they one object, one of each two boxes would
/// be false: one such frame may be a detector's mistake, some more are not.
[[nodiscard]] double TogetherCost(const TrackedObject& a, const TrackedObject& b);

[[nodiscard]] inline bool AreSeenTogether(const TrackedObject& a, const TrackedObject& b) {
  return TogetherCost(a, b) >= kTwoObjectsCost;
}

/// The other way round: that they are two, though two objects of that radius do not overlap. From
/// the difference of their places and its covariance.
[[nodiscard]] double OverlapCost(const Eigen::Vector3d& d, const Eigen::Matrix3d& covariance,
                                 double radius);

}  // namespace limpet
