// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace limpet {

/// Where a program of that name is in PATH.
[[nodiscard]] std::optional<std::filesystem::path> FindInPath(const std::string& name);

}  // namespace limpet
