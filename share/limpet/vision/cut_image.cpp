// SPDX-License-Identifier: MIT
#include "limpet/vision/cut_image.hpp"

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace limpet {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kJpegStart = "\xFF\xD8\xFF"sv;
constexpr std::string_view kPngStart = "\x89PNG\r\n\x1A\n"sv;

std::uint8_t ByteAt(std::string_view bytes, std::size_t at) {
  return static_cast<std::uint8_t>(bytes[at]);
}

std::size_t BigEndian(std::string_view bytes) {
  std::size_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    value = value << 8U | ByteAt(bytes, i);
  return value;
}

/// Markers inside a picture's own bytes, which no length follows.
bool IsInScan(std::uint8_t marker) {
  constexpr std::uint8_t kStuffed = 0x00, kTemporary = 0x01, kFirstRestart = 0xD0, kStart = 0xD8;
  return marker == kStuffed || marker == kTemporary ||
         (marker >= kFirstRestart && marker <= kStart);
}

/// From marker to marker up to the end of the image: an Exif block may hold a whole small JPEG with
/// an end of its own, and cameras write more behind the end.
bool IsCutJpeg(std::string_view bytes) {
  constexpr std::uint8_t kEnd = 0xD9, kFill = 0xFF;
  std::size_t at = 2;
  while ((at = bytes.find('\xFF', at)) != std::string_view::npos && at + 1 < bytes.size()) {
    const std::uint8_t marker = ByteAt(bytes, ++at);
    if (marker == kEnd) return false;
    if (marker == kFill) continue;
    ++at;
    if (IsInScan(marker)) continue;
    if (at + 2 > bytes.size()) return true;
    at += BigEndian(bytes.substr(at, 2));
  }
  return true;
}

bool IsCutPng(std::string_view bytes) {
  constexpr std::size_t kAround = 12;  // length, name and checksum of a chunk
  std::size_t at = kPngStart.size();
  while (at + kAround <= bytes.size()) {
    const std::size_t end = at + kAround + BigEndian(bytes.substr(at, 4));
    if (bytes.substr(at + 4, 4) == "IEND") return end > bytes.size();
    at = end;
  }
  return true;
}

}  // namespace

bool IsCutShort(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string bytes(kPngStart.size(), '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  const bool is_jpeg = bytes.starts_with(kJpegStart), is_png = bytes == kPngStart;
  if (!is_jpeg && !is_png) return false;
  bytes.append(std::istreambuf_iterator<char>(in), {});
  return is_jpeg ? IsCutJpeg(bytes) : IsCutPng(bytes);
}

}  // namespace limpet
