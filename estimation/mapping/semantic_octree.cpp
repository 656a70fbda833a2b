// SPDX-License-Identifier: MIT
#include "estimation/mapping/semantic_octree.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <octomap/OcTreeNode.h>
#include <octomap/OccupancyOcTreeBase.h>

#include "estimation/mapping/octree_stream.hpp"

namespace limpet {
namespace {

constexpr auto kClamp = static_cast<float>(kMostVoxelLogOdds);

octomap::point3d PointOf(const Eigen::Vector3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}
Eigen::Vector3d VectorOf(const octomap::point3d& p) { return {p.x(), p.y(), p.z()}; }

/// OctoMap calls these by their names in the derived class: hiding them is how a node gets a
/// payload.
class SemanticNode : public octomap::OcTreeNode {
 public:
  float object = 0.0F;
  float exists = 0.0F;
  std::uint8_t label = 0;

  [[nodiscard]] bool operator==(const SemanticNode& other) const {
    return value == other.value && object == other.object && exists == other.exists &&
           label == other.label;
  }
  void copyData(const SemanticNode& from) {
    OcTreeNode::copyData(from);
    object = from.object;
    exists = from.exists;
    label = from.label;
  }
  std::istream& readData(std::istream& in) {
    in.read(reinterpret_cast<char*>(&value), sizeof value);
    in.read(reinterpret_cast<char*>(&object), sizeof object);
    in.read(reinterpret_cast<char*>(&exists), sizeof exists);
    return in.read(reinterpret_cast<char*>(&label), sizeof label);
  }
  std::ostream& writeData(std::ostream& out) const {
    out.write(reinterpret_cast<const char*>(&value), sizeof value);
    out.write(reinterpret_cast<const char*>(&object), sizeof object);
    out.write(reinterpret_cast<const char*>(&exists), sizeof exists);
    return out.write(reinterpret_cast<const char*>(&label), sizeof label);
  }
};

class SemanticTree : public octomap::OccupancyOcTreeBase<SemanticNode> {
 public:
  explicit SemanticTree(double edge) : octomap::OccupancyOcTreeBase<SemanticNode>(edge) {
    registration.EnsureLinking();
  }
  [[nodiscard]] SemanticTree* create() const override { return new SemanticTree(resolution); }
  [[nodiscard]] std::string getTreeType() const override { return kSemanticTreeType; }

 private:
  /// Makes the type known to AbstractOcTree::read.
  struct Registration {
    Registration() {
      auto* prototype = new SemanticTree(0.1);  // owned by OctoMap's table
      prototype->clearKeyRays();
      AbstractOcTree::registerTreeType(prototype);
    }
    void EnsureLinking() const {}
  };
  static const Registration registration;
};
const SemanticTree::Registration SemanticTree::registration;

VoxelBelief BeliefOf(const SemanticNode& node) {
  return {node.getLogOdds(), node.object, node.exists, static_cast<VoxelLabel>(node.label)};
}

}  // namespace

class SemanticOctree::Impl {
 public:
  explicit Impl(std::unique_ptr<SemanticTree> octree) : tree(std::move(octree)) {}
  std::unique_ptr<SemanticTree> tree;
};

SemanticOctree::SemanticOctree(Meters resolution)
    : impl_(std::make_unique<Impl>(std::make_unique<SemanticTree>(resolution.value()))) {}
SemanticOctree::~SemanticOctree() = default;
SemanticOctree::SemanticOctree(SemanticOctree&&) noexcept = default;
SemanticOctree& SemanticOctree::operator=(SemanticOctree&&) noexcept = default;

void SemanticOctree::Set(const Eigen::Vector3d& p_W, const VoxelBelief& belief) {
  SemanticTree& tree = *impl_->tree;
  const float occupied =
      std::clamp(belief.occupied, tree.getClampingThresMinLog(), tree.getClampingThresMaxLog());
  // Lazy: an eager update may prune and hand back the parent, which stands for eight voxels.
  if (SemanticNode* node = tree.setNodeValue(PointOf(p_W), occupied, true)) {
    node->object = std::clamp(belief.object, -kClamp, kClamp);
    node->exists = std::clamp(belief.exists, -kClamp, kClamp);
    node->label = static_cast<std::uint8_t>(belief.label);
  }
}

std::optional<VoxelBelief> SemanticOctree::At(const Eigen::Vector3d& p_W) const {
  const SemanticNode* node = impl_->tree->search(PointOf(p_W));
  return node != nullptr ? std::optional<VoxelBelief>(BeliefOf(*node)) : std::nullopt;
}

Eigen::Vector3d SemanticOctree::CentreOf(const Eigen::Vector3d& p_W) const {
  return VectorOf(impl_->tree->keyToCoord(impl_->tree->coordToKey(PointOf(p_W))));
}

double SemanticOctree::resolution() const { return impl_->tree->getResolution(); }
std::size_t SemanticOctree::nodes() const { return impl_->tree->size(); }

void SemanticOctree::ForEachLeaf(const std::function<void(const Voxel&)>& visit) const {
  for (auto leaf = impl_->tree->begin_leafs(); leaf != impl_->tree->end_leafs(); ++leaf) {
    visit(
        {.p_W = VectorOf(leaf.getCoordinate()), .size = leaf.getSize(), .belief = BeliefOf(*leaf)});
  }
}

std::vector<Voxel> SemanticOctree::Leaves() const {
  std::vector<Voxel> leaves;
  ForEachLeaf([&leaves](const Voxel& leaf) { leaves.push_back(leaf); });
  return leaves;
}

void SemanticOctree::AddLeaf(const Voxel& leaf) {
  const double edge = resolution();
  const int n = std::max(1, static_cast<int>(std::lround(leaf.size / edge)));
  const Eigen::Vector3d first = leaf.p_W + Eigen::Vector3d::Constant(0.5 * (edge - n * edge));
  for (int i = 0; i < n * n * n; ++i) {
    Set(first + edge * Eigen::Vector3d(i % n, i / n % n, i / n / n), leaf.belief);
  }
}

void SemanticOctree::Merge() {
  impl_->tree->updateInnerOccupancy();
  impl_->tree->prune();
}

std::string SemanticOctree::Serialize() const {
  impl_->tree->updateInnerOccupancy();
  impl_->tree->prune();
  std::ostringstream out(std::ios::binary);
  impl_->tree->write(out);
  return std::move(out).str();
}

Expected<SemanticOctree> SemanticOctree::Parse(const std::string& bytes) {
  const Expected<OctreeHeader> header = CheckOctreeStream(bytes);
  if (!header) {
    return header.error();
  }
  SemanticOctree octree(Meters(header->resolution));
  std::istringstream in(bytes.substr(header->data_begin), std::ios::binary);
  if (header->nodes > 0) {
    octree.impl_->tree->readData(in);
  }
  return octree;
}

}  // namespace limpet
