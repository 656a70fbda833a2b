// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "limpet/core/units.hpp"
#include "limpet/objects/box.hpp"

namespace limpet {

/// A box cut out of its image with some of what is around it: what a person looks at to judge what
/// the detector saw.
struct ImageChip {
  Box box;           ///< in the image that it was cut from; `landmark` is not carried
  std::string jpeg;  ///< bytes of a JPEG file
};

/// All chips of one image.
struct ImageChips {
  Seconds exposure;  ///< MOOS time
  std::vector<ImageChip> chips;
};

}  // namespace limpet
