// SPDX-License-Identifier: MIT
#include "estimation/mapping/octree_stream.hpp"

#include <algorithm>
#include <bit>
#include <optional>
#include <vector>

#include "limpet/core/number_text.hpp"

namespace limpet {
namespace {

constexpr std::string_view kMagic = "# Octomap OcTree file";
constexpr std::size_t kPayload = 13;  ///< three f32 and the label
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
    const auto children = static_cast<unsigned char>(data[position + kPayload]);
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

}  // namespace limpet
