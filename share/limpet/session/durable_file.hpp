// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "limpet/core/expected.hpp"

namespace limpet {

/// Writes a whole file so that a crash leaves either the old or the new one: writes aside, syncs,
/// renames, syncs the folder. The complaint if that failed; then the old file is untouched.
[[nodiscard]] std::optional<Error> WriteDurably(const std::filesystem::path& file,
                                                std::string_view bytes);
/// Makes the entries of a folder durable.
[[nodiscard]] std::optional<Error> SyncFolder(const std::filesystem::path& folder);
[[nodiscard]] Expected<std::string> ReadWhole(const std::filesystem::path& file);

}  // namespace limpet
