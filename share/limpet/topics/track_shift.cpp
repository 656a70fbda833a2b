// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

#include "limpet/topics/navigation.hpp"

namespace limpet {

std::optional<PlaceSigma> TrackShift::SigmaAt(double t) const {
  const auto next = std::ranges::partition_point(
      sigmas, [t](const std::array<double, 3>& known) { return known[0] < t; });
  if (next == sigmas.end()) return std::nullopt;
  const auto& after = *next;
  const auto& before = next == sigmas.begin() ? after : *std::prev(next);
  const double span = after[0] - before[0];
  const double share = span > 0.0 ? (t - before[0]) / span : 1.0;
  return PlaceSigma{.absolute = before[1] + share * (after[1] - before[1]),
                    .beside = before[2] + share * (after[2] - before[2])};
}

Pose TrackShift::Apply(double t, const Pose& X_WB) const {
  const auto is_before = [t](const std::array<double, 5>& step) { return step[0] < t; };
  const auto next = std::ranges::partition_point(steps, is_before);
  if (next == steps.end()) {
    return X_WB;
  }
  const auto& after = *next;
  const auto& before = next == steps.begin() ? after : *std::prev(next);
  const double span = after[0] - before[0];
  const double share = span > 0.0 ? (t - before[0]) / span : 1.0;
  const auto shift = [&](std::size_t i) { return before[i] + share * (after[i] - before[i]); };
  Pose moved = X_WB;
  moved.p_WB += Eigen::Vector3d(shift(1), shift(2), shift(3));
  moved.yaw = WrapAngle(moved.yaw + shift(4));
  return moved;
}

}  // namespace limpet
