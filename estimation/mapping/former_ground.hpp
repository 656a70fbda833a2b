// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "estimation/mapping/map_tile.hpp"
#include "estimation/matching/frame_offset.hpp"
#include "limpet/core/expected.hpp"

namespace limpet {

/// What a former session knew of the ground and the water above it, laid into this session's frame
/// as that becomes known. Of its log-odds half is kept, so that five beams that say otherwise
/// overrule it. Tiles are kept as they were saved, packed; a few are unpacked at a time.
class FormerGround {
 public:
  /// A voxel of the former session's, as it lies in this one's frame.
  struct Laid {
    VoxelIndex key{};
    float occupied = 0.0F;  ///< half of the former session's log-odds
  };

  explicit FormerGround(double resolution) : resolution_(resolution) {}

  /// A tile of the former session's map; of it what was seen of the ground. The error says why it
  /// is not taken.
  [[nodiscard]] std::optional<Error> Add(const MapTile& tile);
  /// The former session's frame in this one; steps that no voxel would show are none. True if it is
  /// another one than before.
  bool SetOffset(const FrameOffset& offset);

  /// Tiles of this session that may have some of it, by key.
  [[nodiscard]] std::vector<TileKey> Tiles() const;
  /// Those that may have some of one of the former session's tiles.
  [[nodiscard]] std::vector<TileKey> TilesOf(const TileKey& former) const;
  /// What lies in a tile of this session, by key, each once: where two come to lie in one voxel,
  /// what is occupied stays so. Holds until the next call.
  [[nodiscard]] const std::vector<Laid>& LaidIn(const TileKey& tile) const;
  /// Half of the log-odds that a voxel is occupied; nothing where the former session knew nothing.
  [[nodiscard]] std::optional<float> At(const VoxelKey& key) const;

 private:
  /// A cube of `edge` voxels each way, in the former session's frame.
  struct Cube {
    VoxelIndex corner{};
    std::int32_t edge = 1;
    float occupied = 0.0F;
  };
  using Cubes = std::vector<Cube>;
  /// Indices of tiles, both ends among them.
  struct TileBox {
    TileKey from, to;
  };

  [[nodiscard]] TileBox BoxOf(const TileKey& former) const;
  [[nodiscard]] Cubes CubesOf(const std::string& octree) const;
  [[nodiscard]] const Cubes& CubesOf(const TileKey& former) const;
  void LayCubes(const Cubes& cubes, const TileKey& tile) const;

  double resolution_;
  std::map<TileKey, std::string> packed_;
  FrameOffset offset_;
  struct Unpacked {
    TileKey key;
    Cubes cubes;
  };
  mutable std::deque<Unpacked> unpacked_;  ///< latest first
  mutable std::optional<TileKey> laid_tile_;
  mutable std::vector<Laid> laid_;
};

}  // namespace limpet
