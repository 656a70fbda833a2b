// SPDX-License-Identifier: MIT
// Whole files and folders that a power cut leaves as they were or as they are to be.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "limpet/core/expected.hpp"
#include "limpet/durable/file_system.hpp"

namespace limpet {

/// Writes a whole file so that a crash leaves either the old or the new one: writes aside, syncs,
/// renames, syncs the folder. The complaint if that failed; then the old file is untouched, unless
/// the folder alone could not be synced.
[[nodiscard]] std::optional<Error> WriteDurably(const std::filesystem::path& file,
                                                std::string_view bytes,
                                                FileSystem& disk = RealFileSystem());
/// Writes a file that nothing refers to yet: content and size are durable, its name is not.
[[nodiscard]] std::optional<Error> WriteContent(const std::filesystem::path& file,
                                                std::string_view bytes, FileSystem& disk);
/// Makes the entries of a folder durable.
[[nodiscard]] std::optional<Error> SyncFolder(const std::filesystem::path& folder,
                                              FileSystem& disk = RealFileSystem());
/// Creates a folder and those above it that are missing, each durably.
[[nodiscard]] std::optional<Error> CreateFolders(const std::filesystem::path& folder,
                                                 FileSystem& disk = RealFileSystem());
/// Removes a folder and all that is in it, as far as that can be done. Links are not followed.
void RemoveFolder(const std::filesystem::path& folder, FileSystem& disk = RealFileSystem());
[[nodiscard]] Expected<std::string> ReadWhole(const std::filesystem::path& file);

}  // namespace limpet
