// SPDX-License-Identifier: MIT
// A session whose pSession had no orderly end: a power cut, or all processes killed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace limpet {

/// The journal beside a saved session, of what pSession heard: there while the session is under
/// way, and after it was cut short; nothing after an orderly end. `folder`: the session's run
/// folder, or the session folder in it.
[[nodiscard]] std::optional<std::filesystem::path> JournalOf(const std::filesystem::path& folder);

/// For whoever reads such a session: what is missing, and what brings it back.
[[nodiscard]] std::optional<std::string> CutNote(const std::filesystem::path& folder);

}  // namespace limpet
