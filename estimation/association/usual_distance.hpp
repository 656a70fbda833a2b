// SPDX-License-Identifier: MIT
#pragma once

namespace limpet {

/// Distance of an object from the camera where nothing tells it [m].
inline constexpr double kUsualDistance = 3.0;

}  // namespace limpet
