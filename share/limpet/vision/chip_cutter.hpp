// SPDX-License-Identifier: MIT
#pragma once

#include "limpet/objects/image_chips.hpp"
#include "limpet/vision/image.hpp"

namespace limpet {

struct ChipForm {
  double context = 1.8;  ///< side of what is cut out, over the longer side of the box
  int side_px = 96;      ///< longest side of the picture: larger ones are reduced
  int quality = 80;      ///< of the JPEG
};

/// Cuts a box out of its image: a square around its middle, as far as that lies inside the image.
/// Equal input gives equal bytes.
[[nodiscard]] ImageChip CutChip(const ImageView& image, const Box& box, const ChipForm& form);

}  // namespace limpet
