// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "estimation/mapping/ground_looks.hpp"
#include "estimation/mapping/semantic_map.hpp"
#include "limpet/session/map_tile_table.hpp"
#include "limpet/topics/map_tile.hpp"

namespace limpet {

/// Tells of a map by tiles: those that are other than when they were last told.
class MapTeller {
 public:
  /// Tiles looked at when the map is asked for, and, of a large one of which all is other than
  /// before, in each tick after.
  static constexpr int kAtOnce = 64, kPerTick = 16;

  MapTeller(SemanticMap& map, GroundLooks& looks) : map_(map), looks_(looks) {}

  /// What has changed by now is to be told.
  void Begin();
  /// All of the map is to be told, also what is as it was.
  void BeginAnew();
  /// The next tile that is other than it was told; nothing once the map has been told, or where
  /// `most` tiles, which it counts down, have been looked at.
  [[nodiscard]] std::optional<MapTile> Next(int& most);
  /// Whether tiles are still to be looked at.
  [[nodiscard]] bool is_at_it() const { return !due_.empty(); }
  /// What has been told so far.
  [[nodiscard]] MapTileList told() const { return table_.List(); }

 private:
  SemanticMap& map_;
  GroundLooks& looks_;
  std::set<TileKey> due_;
  /// Checksums of tiles' octrees as they were told: packing them takes far longer than this.
  std::map<TileKey, std::string> checksums_;
  MapTileTable table_;
};

}  // namespace limpet
