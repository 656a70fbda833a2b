// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace limpet {

/// A small picture; pixel rows from the top.
struct RgbaImage {
  using Pixel = std::array<std::uint8_t, 4>;  ///< red, green, blue, opacity
  int width = 0;
  int height = 0;
  std::vector<Pixel> pixels;  ///< row by row
};

/// The image as a PNG file.
[[nodiscard]] std::vector<std::uint8_t> EncodePng(const RgbaImage& image);

[[nodiscard]] std::string Base64(std::span<const std::uint8_t> bytes);

}  // namespace limpet
