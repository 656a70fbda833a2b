// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace limpet {

/// A range measured from a place in the plane [m].
struct RangeFrom {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  double range = 0.0;
};

/// Where a beacon is that was ranged from several places: least squares from sixteen starts about
/// the first of them. Nothing while the places do not tell: on a straight way the mirrored place
/// fits as well, and a short way leaves the place unsure. `sigma` [m] of a range, of any error that
/// ranges from neighbouring places share too.
[[nodiscard]] std::optional<Eigen::Vector2d> StartOfBeacon(const std::vector<RangeFrom>& ranges,
                                                           double sigma);

}  // namespace limpet
