// SPDX-License-Identifier: MIT
#pragma once

namespace limpet {

/// What a body at rest is pushed up with, [m/s^2]: at sea level it differs by 0.3 % from the
/// equator to the poles.
inline constexpr double kGravity = 9.81;

}  // namespace limpet
