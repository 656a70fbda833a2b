// SPDX-License-Identifier: MIT
#include "limpet/session/saved_session.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "limpet/mission/mission_file.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMapApp = "pMap";

ConfigError RefusalOf(const std::string& file, const std::string& why) {
  return ConfigError(ConfigProblem{.where = {.file = file, .line = 0}, .key = "", .text = why});
}

std::optional<ConfigBlock> BlockIn(const SavedSession& session, const std::string& app,
                                   const std::string& name, const std::string& text) {
  const fs::path file = session.folder / "mission" / name;
  const MissionFile mission = ParseMission(text, file.string());
  const ConfigBlock* block = mission.Block(app);
  if (block != nullptr) return *block;
  // Of a mission as it was run, no block means that the app flew with its defaults.
  const bool is_complete = name == kMissionAsRun;
  return is_complete
             ? std::optional<ConfigBlock>(
                   {.name = app, .where = {.file = file.string(), .line = 0}, .entries = {}})
             : std::nullopt;
}

/// In quotes, so that none of `special` is taken for more than text. A line has one pair of quotes
/// that the reader takes off, the first: it ends before the value's own.
std::string Quoted(const std::string& value, std::string_view special) {
  if (value.find("//") == std::string::npos && value.find_first_of(special) == std::string::npos) {
    return value;
  }
  const std::size_t own_quote = std::min(value.find('"'), value.size());
  return fmt::format("\"{}\"{}", value.substr(0, own_quote), value.substr(own_quote));
}

}  // namespace

SavedSession LoadSavedSession(const fs::path& folder, const std::string& what) {
  Expected<StoredSession> stored = LoadSession(folder);
  if (!stored) throw RefusalOf(what, stored.error().text);
  Expected<SessionMemory> memory = MemoryOf(stored->files);
  if (!memory) throw RefusalOf(what + " " + folder.string(), memory.error().text);
  return {folder, stored->facts, *std::move(memory)};
}

std::string MissionText(const std::vector<ConfigEntry>& globals,
                        const std::vector<ConfigBlock>& blocks) {
  std::string text = "// The mission as it was run: plugs expanded, settings in place.\n\n";
  for (const ConfigEntry& global : globals) {
    text += fmt::format("{} = {}\n", global.key, Quoted(global.value, "\"{} \t"));
  }
  for (const ConfigBlock& block : blocks) {
    text += fmt::format("\nProcessConfig = {}\n{{\n", block.name);
    const bool keeps_quotes = block.name.starts_with("pHelm");  // as the reader does
    for (const ConfigEntry& entry : block.entries) {
      text += fmt::format("  {} = {}\n", entry.key,
                          keeps_quotes ? entry.value : Quoted(entry.value, "\"{}"));
    }
    text += "}\n";
  }
  return text;
}

std::optional<ConfigBlock> BlockOf(const SavedSession& session, const std::string& app) {
  const auto& files = session.memory.mission;
  if (const auto as_run = files.find(kMissionAsRun); as_run != files.end()) {
    return BlockIn(session, app, as_run->first, as_run->second);
  }
  for (const auto& [name, text] : files) {
    if (!name.ends_with(".moos")) continue;
    if (std::optional<ConfigBlock> block = BlockIn(session, app, name, text)) return block;
  }
  return std::nullopt;
}

SessionPrior PriorWithParameters(const SavedSession& session) {
  SessionPrior prior = PriorOf(session.facts, session.memory);
  if (const std::optional<ConfigBlock> block = BlockOf(session, kMapApp)) {
    for (const ConfigEntry& entry : block->entries) {
      prior.map_parameters.push_back({entry.key, entry.value});
    }
  }
  return prior;
}

}  // namespace limpet
