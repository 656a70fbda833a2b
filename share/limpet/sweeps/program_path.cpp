// SPDX-License-Identifier: MIT
#include "limpet/sweeps/program_path.hpp"

#include <cstdlib>

#include <unistd.h>

#include "limpet/core/config.hpp"

namespace limpet {

std::optional<std::filesystem::path> FindInPath(const std::string& name) {
  const char* path = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe): read only
  for (const std::string& folder : Split(path != nullptr ? path : "", ':')) {
    const std::filesystem::path file = std::filesystem::path(folder) / name;
    if (!folder.empty() && ::access(file.c_str(), X_OK) == 0) return file;
  }
  return std::nullopt;
}

}  // namespace limpet
