// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "estimation/mapping/echo_cells.hpp"

namespace limpet {

/// Greatest length of a group, north or east [m]: the convex outline of a longer wall that bends
/// would take in the water before it.
inline constexpr double kLongestGroup = 4.0;
/// Cells that lie together, group by group, none longer than `kLongestGroup` north or east.
[[nodiscard]] std::vector<std::vector<EchoCells::Cell>> GroupsOf(
    const std::vector<EchoCells::Cell>& cells, double cell_m);

/// The convex outline of a group's echoes and `around` [m] beyond: corners north, east. Those that
/// stick out by less than a tenth of a metre are left out.
[[nodiscard]] std::vector<std::array<double, 2>> OutlineOf(
    const std::vector<EchoCells::Cell>& group, double around);
/// How far a place is outside a convex outline [m]; 0 inside.
[[nodiscard]] double Outside(const std::vector<std::array<double, 2>>& outline,
                             const Eigen::Vector2d& p_W);

}  // namespace limpet
