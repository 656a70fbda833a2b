// SPDX-License-Identifier: MIT
#include "limpet/session/landmark_rows.hpp"

#include <algorithm>

namespace limpet {

std::optional<Eigen::MatrixXd> CovarianceOf(const std::vector<int>& ids,
                                            const LandmarkCovariance& joint) {
  std::vector<Eigen::Index> rows;
  for (const int id : ids) {
    const auto found = std::ranges::find(joint.ids, id);
    if (found == joint.ids.end()) return std::nullopt;
    const Eigen::Index first = 3 * (found - joint.ids.begin());
    rows.insert(rows.end(), {first, first + 1, first + 2});
  }
  return joint.cov_W(rows, rows);
}

}  // namespace limpet
