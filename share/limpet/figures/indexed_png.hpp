// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace limpet {

/// A small raster with up to 256 colours; pixel rows from the top.
struct IndexedImage {
  struct Color {
    std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;
  };
  int width = 0;
  int height = 0;
  std::vector<Color> colors;
  std::vector<std::uint8_t> pixels;  ///< index of a colour, row by row
};

/// The image as a PNG file. Written without compression and without a library: the rasters are a
/// few kilobytes, and OpenCV's codecs would load a hundred shared libraries for them.
[[nodiscard]] std::vector<std::uint8_t> EncodePng(const IndexedImage& image);

[[nodiscard]] std::string Base64(std::span<const std::uint8_t> bytes);

}  // namespace limpet
