// SPDX-License-Identifier: MIT
#include "estimation/mapping/former_ground.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "estimation/mapping/octree_stream.hpp"

namespace limpet {
namespace {

/// Beams do not fill cubes wider than so many voxels with the same; nor does a tile hold them.
constexpr double kWidest = kTileVoxels;
constexpr float kKept = 0.5F;
/// Tiles that are unpacked at the same time: those around one of this session, and their next ones.
constexpr std::size_t kUnpacked = 16;

/// Middles of the voxels at a tile's corners, at the origin's depth [m].
std::array<Eigen::Vector3d, 4> CornersOf(const TileKey& tile, double resolution) {
  const double edge = (kTileVoxels - 1) * resolution;
  const double north = (kTileVoxels * tile.north + 0.5) * resolution;
  const double east = (kTileVoxels * tile.east + 0.5) * resolution;
  return {Eigen::Vector3d(north, east, 0.0), Eigen::Vector3d(north + edge, east, 0.0),
          Eigen::Vector3d(north, east + edge, 0.0),
          Eigen::Vector3d(north + edge, east + edge, 0.0)};
}

/// Whether all voxels of a tile's octree lie in its square, but for such as no tile holds.
bool LiesInItsTile(const std::string& octree, const OctreeHeader& header, const TileKey& tile) {
  bool is_inside = true;
  ForEachLeafOf(octree, header, [&](const Voxel& leaf) {
    const bool is_wide = leaf.size > kWidest * header.resolution;
    is_inside = is_inside && (is_wide || TileOf(KeyOf(leaf.p_W, header.resolution)) == tile);
  });
  return is_inside;
}

}  // namespace

std::optional<Error> FormerGround::Add(const MapTile& tile) {
  const Expected<std::string> octree = tile.Octree();
  if (!octree) return octree.error();
  const Expected<OctreeHeader> header = CheckOctreeStream(*octree);
  if (!header) return header.error();
  if (header->resolution != resolution_) {
    return Error{fmt::format("voxels of {:g} m, where this mission's are of {:g} m",
                             header->resolution, resolution_)};
  }
  if (!LiesInItsTile(*octree, *header, tile.key)) {
    return Error{fmt::format("voxels outside its tile {}, {}", tile.key.north, tile.key.east)};
  }
  packed_[tile.key] = tile.packed;
  unpacked_.clear();
  laid_tile_.reset();
  return std::nullopt;
}

bool FormerGround::SetOffset(const FrameOffset& offset) {
  const double least = 0.25 * resolution_;
  double farthest = 0.0;
  for (const auto& [tile, packed] : packed_) {
    for (const Eigen::Vector3d& corner : CornersOf(tile, resolution_)) {
      farthest = std::max(farthest, (offset.Apply(corner) - offset_.Apply(corner)).norm());
    }
  }
  if (farthest <= least) return false;
  offset_ = offset;
  laid_tile_.reset();
  return true;
}

FormerGround::TileBox FormerGround::BoxOf(const TileKey& former) const {
  Eigen::Vector3d least = Eigen::Vector3d::Constant(1e9), most = -least;
  for (const Eigen::Vector3d& corner : CornersOf(former, resolution_)) {
    least = least.cwiseMin(offset_.Apply(corner));
    most = most.cwiseMax(offset_.Apply(corner));
  }
  return {.from = TileOf(KeyOf(least, resolution_)), .to = TileOf(KeyOf(most, resolution_))};
}

std::vector<TileKey> FormerGround::TilesOf(const TileKey& former) const {
  std::vector<TileKey> tiles;
  const TileBox box = BoxOf(former);
  for (TileKey tile = box.from; tile.north <= box.to.north; ++tile.north) {
    for (tile.east = box.from.east; tile.east <= box.to.east; ++tile.east) {
      tiles.push_back(tile);
    }
  }
  return tiles;
}

std::vector<TileKey> FormerGround::Tiles() const {
  std::vector<TileKey> tiles;
  for (const auto& [former, packed] : packed_) {
    const std::vector<TileKey> of_one = TilesOf(former);
    tiles.insert(tiles.end(), of_one.begin(), of_one.end());
  }
  std::ranges::sort(tiles);
  tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
  return tiles;
}

FormerGround::Cubes FormerGround::CubesOf(const std::string& octree) const {
  Cubes cubes;
  const Expected<OctreeHeader> header = CheckOctreeStream(octree);
  if (!header) return cubes;
  ForEachLeafOf(octree, *header, [&](const Voxel& leaf) {
    const bool is_known_ground =
        leaf.belief.label == VoxelLabel::kGround && leaf.belief.occupied != 0.0F;
    if (!is_known_ground || leaf.size > kWidest * resolution_) return;
    const Eigen::Vector3d first =
        leaf.p_W + Eigen::Vector3d::Constant(0.5 * (resolution_ - leaf.size));
    cubes.push_back({.corner = IndexOf(KeyOf(first, resolution_)),
                     .edge = std::max(1, static_cast<int>(std::lround(leaf.size / resolution_))),
                     .occupied = leaf.belief.occupied});
  });
  return cubes;
}

const FormerGround::Cubes& FormerGround::CubesOf(const TileKey& former) const {
  const auto known = std::ranges::find(unpacked_, former, &Unpacked::key);
  if (known != unpacked_.end()) {
    std::rotate(unpacked_.begin(), known, known + 1);
    return unpacked_.front().cubes;
  }
  if (unpacked_.size() >= kUnpacked) unpacked_.pop_back();
  const Expected<std::string> octree = MapTile{former, packed_.at(former)}.Octree();
  unpacked_.push_front({former, octree ? CubesOf(*octree) : Cubes{}});  // Add has looked at it
  return unpacked_.front().cubes;
}

void FormerGround::LayCubes(const Cubes& cubes, const TileKey& tile) const {
  for (const Cube& cube : cubes) {
    const int n = cube.edge;
    for (int i = 0; i < n * n * n; ++i) {
      const VoxelKey cell{cube.corner[0] + i % n, cube.corner[1] + i / n % n,
                          cube.corner[2] + i / n / n};
      const VoxelKey lies = KeyOf(offset_.Apply(CentreOf(cell, resolution_)), resolution_);
      if (TileOf(lies) != tile) continue;
      laid_.push_back({.key = IndexOf(lies), .occupied = kKept * cube.occupied});
    }
  }
}

const std::vector<FormerGround::Laid>& FormerGround::LaidIn(const TileKey& tile) const {
  if (laid_tile_ == tile) return laid_;
  laid_tile_ = tile;
  laid_.clear();
  for (const auto& [former, packed] : packed_) {
    const TileBox box = BoxOf(former);
    const bool may_reach = box.from.north <= tile.north && tile.north <= box.to.north &&
                           box.from.east <= tile.east && tile.east <= box.to.east;
    if (may_reach) LayCubes(CubesOf(former), tile);
  }
  std::ranges::sort(laid_, [](const Laid& a, const Laid& b) {
    return a.key != b.key ? a.key < b.key : a.occupied > b.occupied;
  });
  const auto is_same = [](const Laid& a, const Laid& b) { return a.key == b.key; };
  laid_.erase(std::unique(laid_.begin(), laid_.end(), is_same), laid_.end());
  return laid_;
}

std::optional<float> FormerGround::At(const VoxelKey& key) const {
  const std::vector<Laid>& laid = LaidIn(TileOf(key));
  const auto found = std::ranges::lower_bound(laid, IndexOf(key), {}, &Laid::key);
  return found != laid.end() && found->key == IndexOf(key) ? std::optional(found->occupied)
                                                           : std::nullopt;
}

}  // namespace limpet
