// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

namespace limpet {

/// Appends `wanted` (such as "share/vehicles") of `folder` and of every folder above it, nearest
/// first, where there is one that `found` lacks.
void AddFoldersAbove(const std::filesystem::path& folder, const std::filesystem::path& wanted,
                     std::vector<std::filesystem::path>& found);

/// Folder that the running program lies in.
[[nodiscard]] std::filesystem::path RunningProgramFolder();

/// Appends `wanted` of the folders around the running program, where `found` lacks it: of those
/// above it, as in a source tree, and of `share/limpet` beside its `bin`, as an installation has
/// them.
void AddFoldersOfProgram(const std::filesystem::path& wanted,
                         std::vector<std::filesystem::path>& found);

}  // namespace limpet
