// SPDX-License-Identifier: MIT
#include "limpet/topics/packed_bytes.hpp"

#include "limpet/packing/gzip_bytes.hpp"

namespace limpet {

Value TopicCodec<PackedBytes>::Encode(const PackedBytes& value) {
  const std::string packed = Gzip(value.bytes, Packing::kFast);
  const auto* first = reinterpret_cast<const std::byte*>(packed.data());
  return Binary(first, first + packed.size());
}

std::optional<PackedBytes> TopicCodec<PackedBytes>::Decode(const Value& value) {
  const auto* binary = std::get_if<Binary>(&value);
  if (binary == nullptr) {
    return std::nullopt;
  }
  const std::string_view bytes(reinterpret_cast<const char*>(binary->data()), binary->size());
  if (!IsGzip(bytes)) {
    return PackedBytes{.bytes = std::string(bytes)};
  }
  Expected<std::string> unpacked = Gunzip(bytes, kMost);
  return unpacked ? std::optional(PackedBytes{.bytes = *std::move(unpacked)}) : std::nullopt;
}

}  // namespace limpet
