// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "limpet/topics/topic.hpp"

namespace limpet {

/// Bytes that travel as gzip: whole maps, of which a message holds more, and a log keeps more, when
/// they are packed. Plain bytes are taken as they are, as older logs have them.
struct PackedBytes {
  std::string bytes;
  bool operator==(const PackedBytes&) const = default;
};

template <>
struct TopicCodec<PackedBytes> {
  [[nodiscard]] static Value Encode(const PackedBytes& value);
  /// Nothing if it is damaged, or would become larger than kMost.
  [[nodiscard]] static std::optional<PackedBytes> Decode(const Value& value);
  static constexpr const char* kWireType = "binary, gzip";
  static constexpr std::size_t kMost = std::size_t{1} << 30U;
};

}  // namespace limpet
