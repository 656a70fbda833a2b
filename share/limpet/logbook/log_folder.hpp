// SPDX-License-Identifier: MIT
// Where the files of a logging session lie, by MOOS's conventions.
#pragma once

#include <filesystem>
#include <string>

#include "limpet/core/expected.hpp"
#include "limpet/core/units.hpp"
#include "limpet/durable/file_system.hpp"

namespace limpet {

/// `21_11_2026_____07_20_00`: day and month without zeros. UTC, or the machine's local time.
[[nodiscard]] std::string LogFolderStamp(Seconds utc, bool is_local);

/// Creates <parent>/<stem>, or, where a former log has that name, <stem>_2, <stem>_3, ...: a log is
/// never overwritten. Durably. Returns the folder; its name is the stem of the files.
[[nodiscard]] Expected<std::filesystem::path> CreateLogFolder(const std::filesystem::path& parent,
                                                              const std::string& stem,
                                                              FileSystem& disk = RealFileSystem());

}  // namespace limpet
