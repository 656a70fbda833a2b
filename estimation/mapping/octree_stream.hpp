// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "estimation/mapping/semantic_octree.hpp"
#include "limpet/core/expected.hpp"

namespace limpet {

inline constexpr const char* kSemanticTreeType = "SemanticOcTree";

struct OctreeHeader {
  double resolution = 0.0;  ///< [m]
  std::size_t nodes = 0;
  std::size_t data_begin = 0;  ///< offset of the first node
};

/// Reads the header of a serialised semantic octree and walks its nodes, so that a reader may then
/// trust their number, their depth and the length of the stream.
[[nodiscard]] Expected<OctreeHeader> CheckOctreeStream(std::string_view bytes);

/// The leaves of a stream whose header that is, as and in the order in which its tree has them. No
/// tree is built, which takes four times the stream's size.
void ForEachLeafOf(std::string_view bytes, const OctreeHeader& header,
                   const std::function<void(const Voxel&)>& visit);

}  // namespace limpet
