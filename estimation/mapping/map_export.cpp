// SPDX-License-Identifier: MIT
#include "estimation/mapping/map_export.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <sstream>

#include <fmt/format.h>
#include <octomap/ColorOcTree.h>

#include "estimation/mapping/octree_stream.hpp"
#include "estimation/mapping/status_label.hpp"
#include "limpet/objects/status_color.hpp"

namespace limpet {
namespace {

std::string_view NameOf(VoxelLabel label) {
  const std::optional<Status> status = StatusOf(label);
  return status ? limpet::NameOf(*status) : "ground";
}

double Probability(float log_odds) { return 1.0 / (1.0 + std::exp(-log_odds)); }

/// What is occupied of a leaf, in voxels of `edge` [m].
void AddCut(const Voxel& leaf, double edge, std::vector<Voxel>& voxels) {
  if (leaf.belief.occupied <= 0.0F) return;
  const int n = std::max(1, static_cast<int>(std::lround(leaf.size / edge)));
  for (int i = 0; i < n * n * n; ++i) {
    const Eigen::Vector3d cell(i % n, i / n % n, i / n / n);
    const Eigen::Vector3d offset =
        (cell + Eigen::Vector3d::Constant(0.5)) * edge - Eigen::Vector3d::Constant(0.5 * leaf.size);
    voxels.push_back({.p_W = leaf.p_W + offset, .size = edge, .belief = leaf.belief});
  }
}

}  // namespace

OccupiedMap OccupiedOf(const SemanticOctree& octree) {
  OccupiedMap map{.resolution = octree.resolution(), .voxels = {}};
  octree.ForEachLeaf([&map](const Voxel& leaf) { AddCut(leaf, map.resolution, map.voxels); });
  return map;
}

Expected<OccupiedMap> OccupiedOfStream(std::string_view bytes) {
  const Expected<OctreeHeader> header = CheckOctreeStream(bytes);
  if (!header) return header.error();
  OccupiedMap map{.resolution = header->resolution, .voxels = {}};
  ForEachLeafOf(bytes, *header,
                [&map](const Voxel& leaf) { AddCut(leaf, map.resolution, map.voxels); });
  return map;
}

VoxelColor ColorOf(const VoxelBelief& belief) {
  const std::optional<Status> status = StatusOf(belief.label);
  if (!status) return {150, 140, 125};  // the seabed's grey
  const std::optional<StatusColor> decided = ColorOf(*status);
  if (!decided) return {240, 228, 66};  // a yellow that stands out against it
  return {decided->red, decided->green, decided->blue};
}

std::string ToCsv(const OccupiedMap& map) {
  std::string text = "north_m,east_m,down_m,size_m,p_occupied,p_object,p_exists,label\n";
  for (const Voxel& voxel : map.voxels) {
    fmt::format_to(std::back_inserter(text),
                   "{:.3f},{:.3f},{:.3f},{:.3f},{:.4f},{:.4f},{:.4f},{}\n", voxel.p_W.x(),
                   voxel.p_W.y(), voxel.p_W.z(), voxel.size, Probability(voxel.belief.occupied),
                   Probability(voxel.belief.object), Probability(voxel.belief.exists),
                   NameOf(voxel.belief.label));
  }
  return text;
}

std::string ToPly(const OccupiedMap& map) {
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
      "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "end_header\n",
      map.voxels.size());
  for (const Voxel& voxel : map.voxels) {
    const VoxelColor color = ColorOf(voxel.belief);
    fmt::format_to(std::back_inserter(text), "{:.3f} {:.3f} {:.3f} {} {} {}\n", voxel.p_W.y(),
                   voxel.p_W.x(), -voxel.p_W.z(), color.red, color.green, color.blue);
  }
  return text;
}

std::string ToColorOctree(const OccupiedMap& map) {
  octomap::ColorOcTree tree(map.resolution);
  for (const Voxel& voxel : map.voxels) {
    const octomap::point3d at(static_cast<float>(voxel.p_W.y()), static_cast<float>(voxel.p_W.x()),
                              static_cast<float>(-voxel.p_W.z()));
    if (octomap::ColorOcTreeNode* node = tree.setNodeValue(at, voxel.belief.occupied, true)) {
      const VoxelColor color = ColorOf(voxel.belief);
      node->setColor(color.red, color.green, color.blue);
    }
  }
  if (!map.voxels.empty()) {
    tree.updateInnerOccupancy();  // ColorOcTree goes to its root without asking whether it has one
  }
  std::ostringstream out(std::ios::binary);
  tree.write(out);
  return std::move(out).str();
}

}  // namespace limpet
