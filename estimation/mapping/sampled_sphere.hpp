// SPDX-License-Identifier: MIT
#pragma once

namespace limpet {

/// A sphere of which points of a grid or of rays stand for the surface [m].
struct SampledSphere {
  double radius = 0.5;
  double spacing = 0.2;  ///< of the points
};

}  // namespace limpet
