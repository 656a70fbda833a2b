// SPDX-License-Identifier: MIT
#include "tests/layers/tree_files.hpp"

#include <fstream>
#include <iterator>

namespace limpet::layers {

std::string ReadAll(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::vector<SourceFile> TreeFiles() {
  const std::filesystem::path root(LIMPET_SOURCE_DIR);
  std::vector<SourceFile> files;
  for (const char* top :
       {"share/limpet", "estimation", "behaviors", "generators", "apps", "training", "tests"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / top)) {
      const std::string extension = entry.path().extension().string();
      if (entry.is_regular_file() && (extension == ".cpp" || extension == ".hpp")) {
        files.push_back(
            {entry.path().lexically_relative(root).generic_string(), ReadAll(entry.path())});
      }
    }
  }
  return files;
}

}  // namespace limpet::layers
