// SPDX-License-Identifier: MIT
// Which folder may include which, as the table of docs/architecture.md says.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace limpet::layers {

struct SourceFile {
  std::string path;  ///< from the repository root
  std::string text;
};

using Names = std::set<std::string, std::less<>>;

/// One row: what a library may use, and the third-party libraries it keeps inside its .cpp files.
struct Layer {
  Names may_use;
  Names hidden;
};
using LayerTable = std::map<std::string, Layer, std::less<>>;

/// Reads the Markdown table whose header begins `| library |`.
[[nodiscard]] LayerTable ReadLayerTable(std::string_view markdown);

/// One complaint per include that the table lacks: `path:line: include: text`. Hidden third-party
/// headers may stand in .cpp files and in headers that no other row of the table can reach.
[[nodiscard]] std::vector<std::string> Violations(const std::vector<SourceFile>& files,
                                                  const LayerTable& table);

}  // namespace limpet::layers
