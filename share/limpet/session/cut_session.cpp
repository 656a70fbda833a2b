// SPDX-License-Identifier: MIT
#include "limpet/session/cut_session.hpp"

#include <fmt/format.h>

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kJournal = "pSession.mail";

/// Of the session folder itself: the run folder that it is in.
fs::path RunFolderOf(const fs::path& folder) {
  const fs::path plain = folder.has_filename() ? folder : folder.parent_path();
  return fs::exists(plain / "manifest.json") ? plain.parent_path() : plain;
}

}  // namespace

std::optional<fs::path> JournalOf(const fs::path& folder) {
  const fs::path journal = RunFolderOf(folder) / kJournal;
  std::error_code unreadable;
  return fs::is_regular_file(journal, unreadable) ? std::optional(journal) : std::nullopt;
}

std::optional<std::string> CutNote(const fs::path& folder) {
  const std::optional<fs::path> journal = JournalOf(folder);
  if (!journal) return std::nullopt;
  return fmt::format(
      "{}: the session is under way, or was cut short; what it heard since it was last saved is in "
      "that file. If it has ended, `limpet session recover {}` brings it in",
      journal->string(), folder.string());
}

}  // namespace limpet
