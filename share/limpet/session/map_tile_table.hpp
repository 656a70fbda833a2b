// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "limpet/topics/map_tile.hpp"

namespace limpet {

/// Name of a tile's file in a saved session: `map/<north>_<east>.ot.gz`.
[[nodiscard]] std::string TileFile(const TileKey& tile);
/// The tile whose file that is; nothing if it is no tile's.
[[nodiscard]] std::optional<TileKey> TileOfFile(std::string_view file);

/// Which tiles make a map, and what their packed bytes come to: who sends a map and who keeps it
/// have equal tables if nothing has been lost between them.
class MapTileTable {
 public:
  /// Takes over a tile as it is now; one without bytes is none any more.
  void Put(const MapTile& tile);
  [[nodiscard]] MapTileList List() const;
  [[nodiscard]] bool Has(const TileKey& tile) const { return checksums_.contains(tile); }

 private:
  std::map<TileKey, std::string> checksums_;
};

}  // namespace limpet
