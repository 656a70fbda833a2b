// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace limpet {

/// True for the name of a log of entries as AlogReader reads them, packed or not.
[[nodiscard]] inline bool IsAlogName(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return name.ends_with(".alog") || name.ends_with(".alog.gz");
}

}  // namespace limpet
