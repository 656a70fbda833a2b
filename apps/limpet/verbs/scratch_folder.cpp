// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/scratch_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

namespace limpet {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder(const std::string& name) {
  std::string pattern = (fs::temp_directory_path() / (name + "_XXXXXX")).string();
  if (::mkdtemp(pattern.data()) == nullptr) {
    throw std::runtime_error(
        fmt::format("cannot make {}: {}", pattern, std::generic_category().message(errno)));
  }
  path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
  std::error_code trouble;  // what is left there does no harm
  fs::remove_all(path_, trouble);
}

}  // namespace limpet
