// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "limpet/topics/byte_stream.hpp"
#include "limpet/topics/chips.hpp"

namespace limpet {
namespace {

constexpr std::size_t kHeader = 16;
constexpr std::size_t kChipHeader = 28;

void PutText(const std::string& text, ByteWriter& out) {
  out.Put(static_cast<std::uint32_t>(text.size()));
  out.Raw(text.data(), text.size());
}

bool GetText(ByteReader& in, std::string& text) {
  std::uint32_t size = 0;
  if (!in.Get(size) || size > in.left()) return false;
  text.resize(size);
  return in.Raw(text.data(), size);
}

void PutChip(const ImageChip& chip, ByteWriter& out) {
  for (const double value : {chip.box.u, chip.box.v, chip.box.w, chip.box.h, chip.box.confidence}) {
    out.Put(static_cast<float>(value));
  }
  PutText(chip.box.color, out);
  PutText(chip.jpeg, out);
}

bool GetChip(ByteReader& in, ImageChip& chip) {
  for (double* value : {&chip.box.u, &chip.box.v, &chip.box.w, &chip.box.h, &chip.box.confidence}) {
    float stored = 0.0F;
    if (!in.Get(stored) || !std::isfinite(stored)) return false;
    *value = static_cast<double>(stored);
  }
  return GetText(in, chip.box.color) && GetText(in, chip.jpeg);
}

}  // namespace

Value TopicCodec<ImageChips>::Encode(const ImageChips& chips) {
  std::size_t size = kHeader;
  for (const ImageChip& chip : chips.chips)
    size += kChipHeader + chip.box.color.size() + chip.jpeg.size();
  ByteWriter out(size);
  out.Magic("LIC1");
  out.Put(static_cast<std::uint32_t>(chips.chips.size()));
  out.Put(chips.exposure.value());
  for (const ImageChip& chip : chips.chips)
    PutChip(chip, out);
  return out.Take();
}

std::optional<ImageChips> TopicCodec<ImageChips>::Decode(const Value& value) {
  const auto* bytes = std::get_if<Binary>(&value);
  if (bytes == nullptr) return std::nullopt;
  ByteReader in(*bytes);
  std::uint32_t count = 0;
  double exposure = 0.0;
  if (!in.HasMagic("LIC1") || !in.Get(count) || !in.Get(exposure) ||
      count > in.left() / kChipHeader) {
    return std::nullopt;
  }
  ImageChips chips{.exposure = Seconds(exposure), .chips = std::vector<ImageChip>(count)};
  for (ImageChip& chip : chips.chips) {
    if (!GetChip(in, chip)) return std::nullopt;
  }
  if (in.left() != 0) return std::nullopt;
  return chips;
}

}  // namespace limpet
