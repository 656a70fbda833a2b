// SPDX-License-Identifier: MIT
#include "limpet/figures/indexed_png.hpp"

#include <algorithm>
#include <string_view>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

using Bytes = std::vector<std::uint8_t>;

void AppendBigEndian(Bytes& out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    out.push_back(static_cast<std::uint8_t>((value >> shift) & 0xffU));
  }
}

/// CRC-32 of PNG, bit by bit: rasters are small.
std::uint32_t Crc(std::span<const std::uint8_t> bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit)
      crc = (crc & 1U) != 0U ? 0xedb88320U ^ (crc >> 1U) : crc >> 1U;
  }
  return ~crc;
}

std::uint32_t Adler(std::span<const std::uint8_t> bytes) {
  std::uint32_t a = 1, b = 0;
  for (const std::uint8_t byte : bytes) {
    a = (a + byte) % 65521U;
    b = (b + a) % 65521U;
  }
  return (b << 16U) | a;
}

void AppendChunk(Bytes& out, std::string_view type, const Bytes& data) {
  AppendBigEndian(out, static_cast<std::uint32_t>(data.size()));
  Bytes checked(type.begin(), type.end());
  checked.insert(checked.end(), data.begin(), data.end());
  out.insert(out.end(), checked.begin(), checked.end());
  AppendBigEndian(out, Crc(checked));
}

/// A zlib stream of stored blocks (RFC 1950, 1951).
Bytes Stored(const Bytes& raw) {
  Bytes out{0x78, 0x01};
  constexpr std::size_t kBlock = 65535;
  for (std::size_t begin = 0; begin < raw.size(); begin += kBlock) {
    const std::size_t size = std::min(kBlock, raw.size() - begin);
    out.push_back(begin + size == raw.size() ? 1 : 0);
    const auto low = static_cast<std::uint8_t>(size & 0xffU);
    const auto high = static_cast<std::uint8_t>(size >> 8U);
    for (const int byte : {+low, +high, 255 - low, 255 - high}) {
      out.push_back(static_cast<std::uint8_t>(byte));
    }
    const auto first = raw.begin() + static_cast<std::ptrdiff_t>(begin);
    out.insert(out.end(), first, first + static_cast<std::ptrdiff_t>(size));
  }
  AppendBigEndian(out, Adler(raw));
  return out;
}

}  // namespace

std::vector<std::uint8_t> EncodePng(const IndexedImage& image) {
  LIMPET_REQUIRE(image.width > 0 && image.height > 0, "an image has pixels");
  const auto width = static_cast<std::size_t>(image.width);
  const auto height = static_cast<std::size_t>(image.height);
  LIMPET_REQUIRE(image.pixels.size() == width * height, "one index per pixel");
  LIMPET_REQUIRE(!image.colors.empty() && image.colors.size() <= 256, "1 to 256 colours");
  Bytes header, colors, alpha, raw;
  AppendBigEndian(header, static_cast<std::uint32_t>(image.width));
  AppendBigEndian(header, static_cast<std::uint32_t>(image.height));
  header.insert(header.end(), {8, 3, 0, 0, 0});  // 8 bits, palette, no interlace
  for (const IndexedImage::Color& color : image.colors) {
    colors.insert(colors.end(), {color.red, color.green, color.blue});
    alpha.push_back(color.alpha);
  }
  for (std::size_t row = 0; row < height; ++row) {
    raw.push_back(0);  // no filter
    const auto first = image.pixels.begin() + static_cast<std::ptrdiff_t>(row * width);
    raw.insert(raw.end(), first, first + static_cast<std::ptrdiff_t>(width));
  }
  Bytes out{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  AppendChunk(out, "IHDR", header);
  AppendChunk(out, "PLTE", colors);
  AppendChunk(out, "tRNS", alpha);
  AppendChunk(out, "IDAT", Stored(raw));
  AppendChunk(out, "IEND", {});
  return out;
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
