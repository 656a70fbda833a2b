// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/random.hpp"

#include "training/detector/studio_canvas.hpp"

namespace limpet {

/// What cameras do to light, drawn anew for each picture: veil and glow, a housing's dark rim,
/// blur, shaking, exposure, colour cast, tone, noise, compression.
[[nodiscard]] cv::Mat3b TakePicture(StudioCanvas canvas, Random& random);

}  // namespace limpet
