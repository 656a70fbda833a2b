// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/topics/sensors.hpp"
#include "limpet/vision/image.hpp"

namespace limpet {

/// How strongly what is in the picture stands out in each channel: spread over mean of linear light
/// over a 40th to a tenth of the image's width, by medians, so that an object here and there counts
/// for little; less what sensor noise alone would show. The time of exposure is the caller's.
///
/// Over one and the same ground it falls as exp(-c d) with the distance d: exposure cancels, what
/// scatters light into the view stays in the mean. All zero for pictures of less than 64 pixels
/// across, and for strips of less than a tenth of their length.
[[nodiscard]] GroundContrast MeasureGroundContrast(ImageView picture);

}  // namespace limpet
