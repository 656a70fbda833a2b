// SPDX-License-Identifier: MIT
// The logs of a run: where they lie below its folder, and which of them is the last.
#pragma once

#include <filesystem>
#include <vector>

#include "limpet/core/units.hpp"

namespace limpet {

/// Every log of entries in a folder and in those below it, packed or not, by path. Throws
/// std::filesystem::filesystem_error if it is no folder.
[[nodiscard]] std::vector<std::filesystem::path> LogsBelow(const std::filesystem::path& folder);

/// MOOS time at which a log begins, by its banner; 0 if it has none or cannot be read.
[[nodiscard]] Seconds StartOfLog(const std::filesystem::path& log);

/// The one that began last, of equals the first. REQUIRES: there is one.
[[nodiscard]] std::filesystem::path LatestLog(const std::vector<std::filesystem::path>& logs);

}  // namespace limpet
