// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "limpet/core/camera_model.hpp"
#include "limpet/imaging/solid.hpp"
#include "limpet/objects/pixel_rect.hpp"

namespace limpet {

/// The upright rectangle around the silhouette of a solid, exact to a thousandth of a pixel: each
/// edge is where a plane through the camera's centre touches the form. Of the part outside the
/// image, too. Nothing if the solid reaches behind the camera.
[[nodiscard]] std::optional<PixelRect> OutlineOf(const CameraModel& camera, const Pose& X_WB,
                                                 const Solid& solid);

}  // namespace limpet
