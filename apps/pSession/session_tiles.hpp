// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "limpet/session/map_tile_table.hpp"
#include "limpet/session/session_memory.hpp"
#include "limpet/topics/map_tile.hpp"

namespace limpet {

/// The map as pMap told it last, tile by tile. What the last saved generation has of it is on the
/// disk alone.
class SessionTiles {
 public:
  /// Tiles as they are at one moment, by file: what is to be written, and what is on the disk.
  struct Files {
    SessionMap to_write;
    std::set<std::string> unchanged;
    std::map<TileKey, std::uint64_t> versions;
  };

  void Put(const MapTile& tile);
  /// The saved generation that is gone on from.
  void GoOnFrom(const SessionMap& saved);
  /// From now on all tiles come again; with EndRetelling those that have not are none any more.
  void BeginRetelling() { retold_.emplace(); }
  void EndRetelling();
  [[nodiscard]] Files FilesNow() const;
  /// These have been saved: as far as they are still the same, the disk alone keeps them.
  void OnSaved(const std::map<TileKey, std::uint64_t>& versions);
  [[nodiscard]] MapTileList List() const { return table_.List(); }
  [[nodiscard]] std::size_t packed_bytes() const;
  /// Whether there are tiles that the disk alone keeps.
  [[nodiscard]] bool has_saved() const;

 private:
  struct Tile {
    std::optional<std::string> packed;  ///< nothing: saved
    std::size_t size = 0;               ///< [bytes]
    std::uint64_t version = 0;
  };

  std::map<TileKey, Tile> tiles_;
  std::uint64_t versions_ = 0;
  std::optional<std::set<TileKey>> retold_;
  MapTileTable table_;
};

}  // namespace limpet
