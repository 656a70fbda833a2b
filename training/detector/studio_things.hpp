// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/random.hpp"

#include "training/detector/studio_canvas.hpp"

namespace limpet {

/// Paints one thing that is no ball: a post, plank, pipe frame, rope, flag, stone, weed, starfish,
/// can, cone, tyre, crescent, lamp, tag, drifting flakes. Many have a buoy's colours.
void PaintThing(StudioCanvas& canvas, Random& random);

}  // namespace limpet
