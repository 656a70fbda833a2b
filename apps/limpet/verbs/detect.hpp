// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace limpet {

/// `limpet detect <images or folders> --out FILE [--min-confidence C]`: runs the detector alone and
/// writes CSV `image,class,confidence,x,y,w,h` in pixels, x and y of the box's upper left corner.
/// A file that cannot be read is named and makes the result 1; the others are still done. Returns
/// the exit code.
int RunDetect(std::span<const std::string> args);

}  // namespace limpet
