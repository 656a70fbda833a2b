// SPDX-License-Identifier: MIT
#include "limpet/core/folders_above.hpp"

#include <algorithm>

namespace limpet {

namespace fs = std::filesystem;

void AddFoldersAbove(const fs::path& folder, const fs::path& wanted, std::vector<fs::path>& found) {
  std::error_code ignored;
  fs::path at = folder;
  for (int level = 0; level < 32 && !at.empty(); ++level) {
    const fs::path candidate = at / wanted;
    const bool is_known = std::ranges::find(found, candidate) != found.end();
    if (!is_known && fs::is_directory(candidate, ignored)) found.push_back(candidate);
    if (at == at.parent_path()) return;
    at = at.parent_path();
  }
}

fs::path RunningProgramFolder() {
  std::error_code ignored;
  return fs::read_symlink("/proc/self/exe", ignored).parent_path();
}

void AddFoldersOfProgram(const fs::path& wanted, std::vector<fs::path>& found) {
  const fs::path program = RunningProgramFolder();
  AddFoldersAbove(program, wanted, found);
  std::error_code ignored;
  const fs::path installed = program.parent_path() / "share" / "limpet" / wanted;
  if (fs::is_directory(installed, ignored)) found.push_back(installed);
}

}  // namespace limpet
