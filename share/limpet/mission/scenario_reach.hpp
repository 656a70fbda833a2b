// SPDX-License-Identifier: MIT
#pragma once

namespace limpet::internal {

/// Farthest distance from the datum, northwards or eastwards [m]: beyond it a local grid means
/// nothing.
inline constexpr double kFarthest_m = 1e5;

}  // namespace limpet::internal
