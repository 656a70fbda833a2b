// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/core/random.hpp"

#include "training/detector/studio_canvas.hpp"

namespace limpet {

/// What is behind everything: open water from bright to dark, the surface from below with its
/// torn reflections, a bottom that fades away, ground seen from above, a tiled or bare wall.
[[nodiscard]] StudioCanvas DrawBackdrop(Random& random);

}  // namespace limpet
