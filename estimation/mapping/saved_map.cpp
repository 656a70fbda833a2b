// SPDX-License-Identifier: MIT
#include "estimation/mapping/saved_map.hpp"

#include <fmt/format.h>

#include "estimation/mapping/map_tile.hpp"
#include "estimation/mapping/octree_stream.hpp"
#include "limpet/packing/gzip_bytes.hpp"

namespace limpet {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 30U;

Expected<std::string> Unpacked(const std::string& bytes) {
  return IsGzip(bytes) ? Gunzip(bytes, kLargestFile) : Expected<std::string>(bytes);
}

/// Shows every file's octree; the error names the file and says what is wrong with it.
std::optional<Error> ForEachFile(
    const MapFiles& files, const std::function<std::optional<Error>(const std::string&)>& show) {
  for (const auto& [name, bytes] : files) {
    const Expected<std::string> octree = Unpacked(bytes);
    const std::optional<Error> error = octree ? show(*octree) : octree.error();
    if (error) return Error{fmt::format("{}: {}", name, error->text)};
  }
  return std::nullopt;
}

Error OtherVoxels(double edge, double before) {
  return Error{
      fmt::format("voxels of {:g} m, in the other tiles they are of {:g} m", edge, before)};
}

}  // namespace

Expected<SemanticOctree> OctreeOf(const MapFiles& files) {
  std::optional<SemanticOctree> whole;
  const std::optional<Error> error =
      ForEachFile(files, [&](const std::string& bytes) -> std::optional<Error> {
        Expected<SemanticOctree> part = SemanticOctree::Parse(bytes);
        if (!part) return part.error();
        if (!whole) {
          whole = *std::move(part);
        } else if (part->resolution() != whole->resolution()) {
          return OtherVoxels(part->resolution(), whole->resolution());
        } else {
          part->ForEachLeaf([&](const Voxel& leaf) { whole->AddLeaf(leaf); });
        }
        return std::nullopt;
      });
  if (error) return *error;
  if (!whole) return SemanticOctree();
  whole->Merge();
  return *std::move(whole);
}

Expected<OccupiedMap> OccupiedOf(const MapFiles& files) {
  OccupiedMap whole;
  const std::optional<Error> error =
      ForEachFile(files, [&](const std::string& bytes) -> std::optional<Error> {
        const Expected<OccupiedMap> part = OccupiedOfStream(bytes);
        if (!part) return part.error();
        if (whole.resolution > 0.0 && part->resolution != whole.resolution) {
          return OtherVoxels(part->resolution, whole.resolution);
        }
        whole.resolution = part->resolution;
        whole.voxels.insert(whole.voxels.end(), part->voxels.begin(), part->voxels.end());
        return std::nullopt;
      });
  if (error) return *error;
  return whole;
}

Expected<std::vector<MapTile>> TilesOf(const std::string& octree) {
  const Expected<OctreeHeader> header = CheckOctreeStream(octree);
  if (!header) return header.error();
  const double edge = header->resolution;
  std::map<TileKey, SemanticOctree> parts;
  ForEachLeafOf(octree, *header, [&](const Voxel& leaf) {
    if (leaf.size > kTileVoxels * edge) return;  // no beams have filled that
    const auto part = parts.try_emplace(TileOf(KeyOf(leaf.p_W, edge)), Meters(edge)).first;
    part->second.AddLeaf(leaf);
  });
  std::vector<MapTile> tiles;
  for (const auto& [key, part] : parts) {
    tiles.push_back(MapTile::Of(key, part.Serialize()));
  }
  return tiles;
}

}  // namespace limpet
