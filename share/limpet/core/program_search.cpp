// SPDX-License-Identifier: MIT
#include "limpet/core/program_search.hpp"

#include <cstdlib>
#include <system_error>

#include <unistd.h>

#include "limpet/core/config.hpp"

namespace limpet {

namespace fs = std::filesystem;

bool IsExecutable(const fs::path& file) {
  std::error_code ignored;
  return ::access(file.c_str(), X_OK) == 0 && !fs::is_directory(file, ignored);
}

std::vector<fs::path> FoldersOnPath() {
  std::vector<fs::path> folders;
  const char* path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): before any thread
  for (const std::string& folder : Split(path != nullptr ? path : "", ':')) {
    if (fs::path(folder).is_absolute()) {
      folders.emplace_back(folder);
    }
  }
  return folders;
}

std::optional<fs::path> FindOnPath(const std::string& program) {
  for (const fs::path& folder : FoldersOnPath()) {
    if (IsExecutable(folder / program)) return folder / program;
  }
  return std::nullopt;
}

}  // namespace limpet
