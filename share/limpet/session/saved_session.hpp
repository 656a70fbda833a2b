// SPDX-License-Identifier: MIT
// A saved session as another program takes it up: what it knew, and the parameters that its map was
// made with.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "limpet/core/config.hpp"
#include "limpet/session/session_memory.hpp"

namespace limpet {

struct SavedSession {
  std::filesystem::path folder;
  SessionFacts facts;
  SessionMemory memory;
};

/// Throws ConfigError, which names the damaged or missing file; `what` is what the session is to
/// the reader.
[[nodiscard]] SavedSession LoadSavedSession(const std::filesystem::path& folder,
                                            const std::string& what);

/// A mission's globals and blocks as text that reads as the same mission.
[[nodiscard]] std::string MissionText(const std::vector<ConfigEntry>& globals,
                                      const std::vector<ConfigBlock>& blocks);

/// An app's block of the mission that the session was flown with: of the mission as it was run,
/// else of the first .moos file that has one. Nothing if the session kept no such mission. Its
/// lines are those of `<folder>/mission/<file>`. Throws ConfigError if the mission cannot be read.
[[nodiscard]] std::optional<ConfigBlock> BlockOf(const SavedSession& session,
                                                 const std::string& app);

/// PriorOf with the parameters of the session's map. Throws ConfigError.
[[nodiscard]] SessionPrior PriorWithParameters(const SavedSession& session);

}  // namespace limpet
