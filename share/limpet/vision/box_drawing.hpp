// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "limpet/topics/sensors.hpp"
#include "limpet/vision/image.hpp"

namespace limpet {

/// Draws each box into the picture, with its class and confidence beside it.
void DrawBoxes(std::span<const Box> boxes, Image& image);

}  // namespace limpet
