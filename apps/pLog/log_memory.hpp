// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "limpet/core/units.hpp"
#include "limpet/durable/file_system.hpp"

namespace limpet {

/// What a logger that is started again must know to go on in the same files.
struct LogMemory {
  std::filesystem::path folder;
  std::string stem;
  Seconds start;  ///< of the log, MOOS time
  [[nodiscard]] std::filesystem::path log() const { return folder / (stem + ".alog"); }
};

/// Writes `file`, durably; a failure shows when nothing is recalled.
void KeepLog(const LogMemory& memory, const std::filesystem::path& file, FileSystem& disk);
/// Nothing if there is none, or its log is gone.
[[nodiscard]] std::optional<LogMemory> RecallLog(const std::filesystem::path& file);

/// Latest time among the last entries of a log, in seconds since its start.
[[nodiscard]] std::optional<double> LatestTimeIn(const std::filesystem::path& log);

}  // namespace limpet
