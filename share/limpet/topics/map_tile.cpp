// SPDX-License-Identifier: MIT
#include "limpet/topics/map_tile.hpp"

#include "limpet/packing/gzip_bytes.hpp"
#include "limpet/topics/byte_stream.hpp"

namespace limpet {
namespace {

constexpr std::size_t kTileHeader = 12;
/// Size of the largest octree of a tile [bytes]: 64 x 64 columns all full to a depth of 400 m with
/// small voxels.
constexpr std::size_t kLargestTile = std::size_t{1} << 28U;

}  // namespace

MapTile MapTile::Of(const TileKey& key, const std::string& octree) {
  return {.key = key, .packed = Gzip(octree, Packing::kFast)};
}

Expected<std::string> MapTile::Octree() const { return Gunzip(packed, kLargestTile); }

Value TopicCodec<MapTile>::Encode(const MapTile& tile) {
  ByteWriter out(kTileHeader + tile.packed.size());
  out.Magic("LMT1");
  out.Put(tile.key.north);
  out.Put(tile.key.east);
  out.Raw(tile.packed.data(), tile.packed.size());
  return out.Take();
}

std::optional<MapTile> TopicCodec<MapTile>::Decode(const Value& value) {
  const auto* bytes = std::get_if<Binary>(&value);
  if (bytes == nullptr) return std::nullopt;
  ByteReader in(*bytes);
  MapTile tile;
  if (!in.HasMagic("LMT1") || !in.Get(tile.key.north) || !in.Get(tile.key.east)) {
    return std::nullopt;
  }
  tile.packed.resize(in.left());
  in.Raw(tile.packed.data(), tile.packed.size());
  const bool is_packed = tile.packed.empty() || IsGzip(tile.packed);
  return is_packed ? std::optional(std::move(tile)) : std::nullopt;
}

}  // namespace limpet
