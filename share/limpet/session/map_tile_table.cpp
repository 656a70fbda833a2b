// SPDX-License-Identifier: MIT
#include "limpet/session/map_tile_table.hpp"

#include <iterator>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"
#include "limpet/session/checksum.hpp"

namespace limpet {
namespace {

constexpr std::string_view kFolder = "map/";
constexpr std::string_view kEnding = ".ot.gz";

std::optional<std::int32_t> TileIndex(std::string_view text) {
  const std::optional<std::int64_t> index = ParseInteger(text);
  const bool fits = index && *index == static_cast<std::int32_t>(*index);
  return fits ? std::optional(static_cast<std::int32_t>(*index)) : std::nullopt;
}

}  // namespace

std::string TileFile(const TileKey& tile) {
  return fmt::format("{}{}_{}{}", kFolder, tile.north, tile.east, kEnding);
}

std::optional<TileKey> TileOfFile(std::string_view file) {
  if (!file.starts_with(kFolder) || !file.ends_with(kEnding)) return std::nullopt;
  file.remove_prefix(kFolder.size());
  file.remove_suffix(kEnding.size());
  const std::size_t middle = file.find('_');
  if (middle == std::string_view::npos) return std::nullopt;
  const auto north = TileIndex(file.substr(0, middle));
  const auto east = TileIndex(file.substr(middle + 1));
  return north && east ? std::optional(TileKey{*north, *east}) : std::nullopt;
}

void MapTileTable::Put(const MapTile& tile) {
  if (tile.packed.empty()) {
    checksums_.erase(tile.key);
  } else {
    checksums_[tile.key] = ChecksumOf(tile.packed);
  }
}

MapTileList MapTileTable::List() const {
  std::string all;
  for (const auto& [tile, checksum] : checksums_) {
    fmt::format_to(std::back_inserter(all), "{},{},{}\n", tile.north, tile.east, checksum);
  }
  return {.tiles = static_cast<int>(checksums_.size()), .checksum = ChecksumOf(all)};
}

}  // namespace limpet
