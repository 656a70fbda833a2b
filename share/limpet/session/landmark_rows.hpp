// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limpet/topics/navigation.hpp"

namespace limpet {

/// The covariance of these landmarks alone, three rows each in the order of `ids`; nothing if one
/// of them is not in `joint`.
[[nodiscard]] std::optional<Eigen::MatrixXd> CovarianceOf(const std::vector<int>& ids,
                                                          const LandmarkCovariance& joint);

}  // namespace limpet
