// SPDX-License-Identifier: MIT
// The semantic map as it travels: in tiles, of which only those that are other than before are
// sent.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>

#include "limpet/core/expected.hpp"
#include "limpet/topics/topic.hpp"

namespace limpet {

/// A square of the semantic map over all depths, by its index along north and east.
struct TileKey {
  std::int32_t north = 0, east = 0;
  auto operator<=>(const TileKey&) const = default;
};

/// A tile as it is sent and saved. Who only passes it on need not unpack it.
struct MapTile {
  TileKey key;
  std::string packed;  ///< its octree, serialised, as gzip; empty: nothing is known there any more
  bool operator==(const MapTile&) const = default;

  [[nodiscard]] static MapTile Of(const TileKey& key, const std::string& octree);
  /// The octree's bytes; the error says what is wrong with them.
  [[nodiscard]] Expected<std::string> Octree() const;
};

/// Magic "LMT1", index along north and east as little-endian i32, then the packed octree.
template <>
struct TopicCodec<MapTile> {
  [[nodiscard]] static Value Encode(const MapTile& tile);
  [[nodiscard]] static std::optional<MapTile> Decode(const Value& value);
  static constexpr const char* kWireType = "binary, gzip";
};

/// Which tiles make the map: by it a reader knows that it has them all, as they are.
struct MapTileList {
  int tiles = 0;
  std::string checksum;  ///< over the tiles' keys and their packed bytes (MapTileTable)
  template <class V>
  void Describe(V& visit) {
    visit("tiles", tiles), visit("xxh3_64", checksum);
  }
  bool operator==(const MapTileList&) const = default;
};

}  // namespace limpet
