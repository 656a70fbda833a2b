// SPDX-License-Identifier: MIT
#include "apps/pSession/session_tiles.hpp"

#include <algorithm>

namespace limpet {

void SessionTiles::Put(const MapTile& tile) {
  table_.Put(tile);
  if (retold_) retold_->insert(tile.key);
  if (tile.packed.empty()) {
    tiles_.erase(tile.key);
  } else {
    tiles_[tile.key] = {.packed = tile.packed, .size = tile.packed.size(), .version = ++versions_};
  }
}

void SessionTiles::GoOnFrom(const SessionMap& saved) {
  for (const auto& [file, packed] : saved) {
    const std::optional<TileKey> key = TileOfFile(file);
    if (!key) continue;  // an older version's, which pMap tells anew
    table_.Put({.key = *key, .packed = packed});
    tiles_[*key] = {.packed = std::nullopt, .size = packed.size(), .version = ++versions_};
  }
}

void SessionTiles::EndRetelling() {
  if (!retold_) return;
  std::erase_if(tiles_, [this](const auto& entry) {
    const bool is_gone = !retold_->contains(entry.first);
    if (is_gone) table_.Put({.key = entry.first, .packed = {}});
    return is_gone;
  });
  retold_.reset();
}

SessionTiles::Files SessionTiles::FilesNow() const {
  Files files;
  for (const auto& [key, tile] : tiles_) {
    if (tile.packed) {
      files.to_write[TileFile(key)] = *tile.packed;
    } else {
      files.unchanged.insert(TileFile(key));
    }
    files.versions[key] = tile.version;
  }
  return files;
}

void SessionTiles::OnSaved(const std::map<TileKey, std::uint64_t>& versions) {
  for (const auto& [key, version] : versions) {
    const auto tile = tiles_.find(key);
    if (tile != tiles_.end() && tile->second.version == version) tile->second.packed.reset();
  }
}

bool SessionTiles::has_saved() const {
  return std::ranges::any_of(tiles_, [](const auto& entry) { return !entry.second.packed; });
}

std::size_t SessionTiles::packed_bytes() const {
  std::size_t sum = 0;
  for (const auto& [key, tile] : tiles_) {
    sum += tile.size;
  }
  return sum;
}

}  // namespace limpet
