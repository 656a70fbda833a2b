// SPDX-License-Identifier: MIT
#include "estimation/mapping/octree_stream.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>
#include <vector>

#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

constexpr std::string_view kMagic = "# Octomap OcTree file";
constexpr std::size_t kPayload = 13;  ///< three f32 and the label
constexpr auto kLastLabel = static_cast<unsigned char>(VoxelLabel::kMoved);
constexpr int kDeepest = 16;

/// The rest of the line that starts with `key`, or nothing.
std::optional<std::string_view> Field(std::string_view header, std::string_view key) {
  std::size_t begin = 0;
  while (begin < header.size()) {
    const std::size_t end = std::min(header.find('\n', begin), header.size());
    const std::string_view line = header.substr(begin, end - begin);
    if (line.starts_with(key) && line.size() > key.size() && line[key.size()] == ' ') {
      return line.substr(key.size() + 1);
    }
    begin = end + 1;
  }
  return std::nullopt;
}

/// Number of nodes of a well-formed stream, or nothing.
std::optional<std::size_t> CountNodes(std::string_view data) {
  std::size_t position = 0;
  std::size_t nodes = 0;
  std::vector<int> open{1};  // nodes still to come, per depth
  while (!open.empty()) {
    if (open.back() == 0) {
      open.pop_back();
      continue;
    }
    --open.back();
    if (position + kPayload + 1 > data.size()) {
      return std::nullopt;
    }
    const auto label = static_cast<unsigned char>(data[position + kPayload - 1]);
    const auto children = static_cast<unsigned char>(data[position + kPayload]);
    if (label > kLastLabel) return std::nullopt;
    position += kPayload + 1;
    ++nodes;
    if (children == 0) continue;
    if (static_cast<int>(open.size()) > kDeepest) {
      return std::nullopt;
    }
    open.push_back(std::popcount(children));
  }
  return position == data.size() ? std::optional<std::size_t>(nodes) : std::nullopt;
}

/// Goes through the nodes of a stream that has been checked.
class LeafReader {
 public:
  LeafReader(std::string_view data, double resolution,
             const std::function<void(const Voxel&)>& visit)
      : data_(data), resolution_(resolution), visit_(visit) {}

  /// The next node and what is below it: `size` voxels wide, from the corner `low` on.
  void Read(const Eigen::Vector3i& low, int size) {
    const VoxelBelief belief{Take<float>(), Take<float>(), Take<float>(), Take<VoxelLabel>()};
    const auto children = Take<unsigned char>();
    if (children == 0) return Visit(low, size, belief);
    const int half = size / 2;
    for (int i = 0; i < 8; ++i) {
      if ((children >> i & 1) == 0) continue;
      Read(low + half * Eigen::Vector3i(i & 1, i >> 1 & 1, i >> 2 & 1), half);
    }
  }

 private:
  template <class T>
  T Take() {
    T value;
    std::memcpy(&value, data_.data() + position_, sizeof value);
    position_ += sizeof value;
    return value;
  }
  void Visit(const Eigen::Vector3i& low, int size, const VoxelBelief& belief) const {
    // In OctoMap's steps, which are of single precision.
    const auto middle = [&](int voxels) {
      return static_cast<double>(static_cast<float>((voxels / size + 0.5) * (resolution_ * size)));
    };
    visit_({.p_W = {middle(low.x()), middle(low.y()), middle(low.z())},
            .size = resolution_ * size,
            .belief = belief});
  }

  std::string_view data_;
  double resolution_;
  const std::function<void(const Voxel&)>& visit_;
  std::size_t position_ = 0;
};

}  // namespace

Expected<OctreeHeader> CheckOctreeStream(std::string_view bytes) {
  constexpr std::string_view kData = "\ndata\n";
  const std::size_t end = bytes.find(kData);
  if (!bytes.starts_with(kMagic) || end == std::string_view::npos) {
    return Error{"not an octree"};
  }
  const std::string_view header = bytes.substr(0, end + 1);
  if (Field(header, "id") != kSemanticTreeType) {
    return Error{"an octree of another type"};
  }
  const std::optional<double> resolution = ParseNumber(Field(header, "res").value_or(""));
  const auto nodes = ParseInteger(Field(header, "size").value_or(""));
  if (!resolution || *resolution <= 0.0 || !nodes || *nodes < 0) {
    return Error{"an octree without resolution or size"};
  }
  const OctreeHeader result{.resolution = *resolution,
                            .nodes = static_cast<std::size_t>(*nodes),
                            .data_begin = end + kData.size()};
  const std::string_view data = bytes.substr(result.data_begin);
  const bool is_empty = result.nodes == 0 && data.empty();
  if (!is_empty && CountNodes(data) != result.nodes) {
    return Error{"an octree that is cut short or damaged"};
  }
  return result;
}

void ForEachLeafOf(std::string_view bytes, const OctreeHeader& header,
                   const std::function<void(const Voxel&)>& visit) {
  if (header.nodes == 0) return;
  constexpr int kHalf = 1 << (kDeepest - 1);
  LeafReader(bytes.substr(header.data_begin), header.resolution, visit)
      .Read(Eigen::Vector3i::Constant(-kHalf), 2 * kHalf);
}

}  // namespace limpet
