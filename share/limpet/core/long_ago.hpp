// SPDX-License-Identifier: MIT
#pragma once

namespace limpet {

/// A time before any that a session hears of [s]: what has not happened yet happened then, so that
/// how long ago something was needs no case of its own.
inline constexpr double kLongAgo = -1e18;

}  // namespace limpet
