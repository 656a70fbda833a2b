// SPDX-License-Identifier: MIT
#include "limpet/figures/rgba_png.hpp"

#include <algorithm>
#include <string_view>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "limpet/core/require.hpp"

namespace limpet {

std::vector<std::uint8_t> EncodePng(const RgbaImage& image) {
  LIMPET_REQUIRE(image.width > 0 && image.height > 0, "an image has pixels");
  const auto pixels =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  LIMPET_REQUIRE(image.pixels.size() == pixels, "one colour per pixel");
  cv::Mat bgra(image.height, image.width, CV_8UC4);
  std::ranges::transform(image.pixels, bgra.begin<cv::Vec4b>(), [](const RgbaImage::Pixel& pixel) {
    return cv::Vec4b(pixel[2], pixel[1], pixel[0], pixel[3]);
  });
  std::vector<std::uint8_t> png;
  const bool is_encoded = cv::imencode(".png", bgra, png, {cv::IMWRITE_PNG_COMPRESSION, 9});
  LIMPET_REQUIRE(is_encoded, "PNG takes any image");
  return png;
}

std::string Base64(std::span<const std::uint8_t> bytes) {
  static constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = (group << 8U) | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) {
      out += k <= count ? kLetters[(group >> (18U - 6U * k)) & 63U] : '=';
    }
  }
  return out;
}

}  // namespace limpet
