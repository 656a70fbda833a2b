// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace limpet {

/// A file that may be executed, and no folder.
[[nodiscard]] bool IsExecutable(const std::filesystem::path& file);
/// Absolute folders alone: a `.` on PATH would search wherever one stands.
[[nodiscard]] std::vector<std::filesystem::path> FoldersOnPath();
/// The program that a shell would start.
[[nodiscard]] std::optional<std::filesystem::path> FindOnPath(const std::string& program);

}  // namespace limpet
