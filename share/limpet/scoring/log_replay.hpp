// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "limpet/core/expected.hpp"
#include "limpet/scoring/session_record.hpp"

namespace limpet {

/// The record of a session from the .alog file in its folder, the same as if it had listened live.
/// A log that ends in the middle, e.g. after a power cut, gives what it holds.
[[nodiscard]] Expected<SessionRecord> RecordFromLog(const std::filesystem::path& session_folder);

}  // namespace limpet
