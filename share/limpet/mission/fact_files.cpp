// SPDX-License-Identifier: MIT
#include "limpet/mission/fact_files.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include "limpet/core/folders_above.hpp"
#include "limpet/core/same_value.hpp"
#include "limpet/mission/detector_settings.hpp"
#include "limpet/mission/mission_places.hpp"
#include "limpet/mission/source_text.hpp"
#include "limpet/mission/vehicle_settings.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

/// A scalar as it stands, a list as `[a, b, c]`; nothing for a map.
std::optional<std::string> TextIn(const YAML::Node& node) {
  if (node.IsScalar()) return node.Scalar();
  if (!node.IsSequence()) return std::nullopt;
  std::vector<std::string> parts;
  for (const YAML::Node& part : node) {
    if (!part.IsScalar()) return std::nullopt;
    parts.push_back(part.Scalar());
  }
  return fmt::format("[{}]", fmt::join(parts, ", "));
}

YAML::Node ReadYaml(const fs::path& file) {
  try {
    return YAML::Load(ReadTextFile(file));
  } catch (const YAML::Exception&) {
  } catch (const ConfigError&) {
  }
  return {};
}

/// The first of a key counts.
void AddEntries(const fs::path& file, std::vector<ConfigEntry>& entries) {
  const YAML::Node root = ReadYaml(file);
  if (!root.IsMap()) return;
  for (const auto& section : root) {
    if (!section.first.IsScalar() || !section.second.IsMap()) continue;
    for (const auto& pair : section.second) {
      if (!pair.first.IsScalar()) continue;
      const std::string key = section.first.Scalar() + "." + pair.first.Scalar();
      const std::optional<std::string> text = TextIn(pair.second);
      if (text && std::ranges::find(entries, key, &ConfigEntry::key) == entries.end()) {
        entries.push_back({key, *text, {file.string(), pair.first.Mark().line + 1}});
      }
    }
  }
}

/// What the file says for a taker; nothing if it does not.
std::optional<ConfigEntry> ValueFor(const FactTaker& taker,
                                    const std::vector<ConfigEntry>& entries) {
  const auto entry = std::ranges::find(entries, taker.fact, &ConfigEntry::key);
  if (entry == entries.end()) return std::nullopt;
  std::string text = entry->value;
  if (taker.part) {
    std::erase_if(text, [](char letter) { return letter == '[' || letter == ']'; });
    const std::vector<std::string> parts = Split(text, ',');
    if (*taker.part >= parts.size()) return std::nullopt;
    text = std::string(Trim(parts[*taker.part]));
  }
  return ConfigEntry{taker.key, text, entry->where};
}

void DropFormer(const FactFile& kind, const FactTaker& taker,
                const std::optional<ConfigEntry>& value, ConfigBlock& block) {
  std::erase_if(block.entries, [&](const ConfigEntry& entry) {
    if (!EqualsIgnoringCase(entry.key, taker.key)) return false;
    if (!value) {
      block.problems.push_back({entry.where, entry.key,
                                fmt::format("`{}`: the {}'s file says it, by its key {}",
                                            entry.value, kind.of, taker.fact)});
    } else if (!IsSameValue(entry.value, value->value)) {
      block.problems.push_back(
          {entry.where, entry.key,
           fmt::format("`{}`: the {}'s file says it, and says {} ({}:{}: {})", entry.value, kind.of,
                       value->value, value->where.file, value->where.line, taker.fact)});
    }
    return true;
  });
}

/// A kind of file that a mission names, where it lies, and what it says.
struct NamedFile {
  const FactFile* kind = nullptr;
  fs::path file;
  std::vector<ConfigEntry> entries;
  std::vector<ConfigProblem> problems;  ///< for blocks that take from it
};

/// Why a file that no app reads for its own sake cannot be taken from as it stands.
std::vector<ConfigProblem> ProblemsOf(const NamedFile& named, const MissionFile& mission) {
  const std::string name = mission.Global(named.kind->global);
  if (named.kind->has_reader || name.empty()) return {};
  if (named.file.empty()) {
    ConfigProblem unknown =
        UnknownFactFile(*named.kind, name, fs::path(mission.file).parent_path());
    unknown.where = LineOfGlobal(mission, named.kind->global);
    return {unknown};
  }
  if (named.entries.empty()) {
    return {{{named.file.string(), 0}, "", "says nothing that could be read: no `section: key:`"}};
  }
  std::vector<std::string> known;
  for (const FactTaker& taker : named.kind->takers)
    known.emplace_back(taker.fact);
  std::vector<ConfigProblem> problems;
  for (const ConfigEntry& entry : named.entries) {
    if (std::ranges::find(known, entry.key) != known.end()) continue;
    const std::string nearest = NearestWord(entry.key, known);
    problems.push_back(
        {entry.where, entry.key,
         fmt::format("is no key of a {}'s file{}", named.kind->of,
                     nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest))});
  }
  return problems;
}

NamedFile ReadNamed(const FactFile& kind, const MissionFile& mission) {
  NamedFile named{
      .kind = &kind,
      .file = FindFactFile(kind, mission.Global(kind.global), fs::path(mission.file).parent_path()),
      .entries = {},
      .problems = {}};
  named.entries = FactEntries(kind, named.file);
  named.problems = ProblemsOf(named, mission);
  return named;
}

void TakeFactsFrom(const NamedFile& named, const std::string& owner, ConfigBlock& block) {
  const bool takes = std::ranges::any_of(named.kind->takers, [&owner](const FactTaker& taker) {
    return EqualsIgnoringCase(owner, taker.owner);
  });
  if (!takes) return;
  block.problems.insert(block.problems.end(), named.problems.begin(), named.problems.end());
  const FactFile& kind = *named.kind;
  const std::vector<ConfigEntry>& entries = named.entries;
  for (const FactTaker& taker : kind.takers) {
    if (!EqualsIgnoringCase(owner, taker.owner)) continue;
    const std::optional<ConfigEntry> value = ValueFor(taker, entries);
    if (taker.is_former) {
      DropFormer(kind, taker, value, block);
    } else if (value && block.Find(taker.key) == nullptr) {
      block.entries.push_back(*value);
    }
  }
}

}  // namespace

const std::vector<const FactFile*>& FactFiles() {
  static const std::vector<const FactFile*> kinds{&VehicleFacts(), &DetectorFacts()};
  return kinds;
}

std::vector<fs::path> FactFolders(const FactFile& kind, const fs::path& mission_folder) {
  std::error_code ignored;
  std::vector<fs::path> folders{mission_folder};
  const fs::path shared = fs::path("share") / kind.folder;
  AddFoldersAbove(fs::absolute(mission_folder, ignored).lexically_normal(), shared, folders);
  AddFoldersOfProgram(shared, folders);
  return folders;
}

fs::path FindFactFile(const FactFile& kind, const fs::path& named, const fs::path& mission_folder) {
  std::error_code ignored;
  if (named.empty()) return {};
  for (const fs::path& folder : FactFolders(kind, mission_folder)) {
    if (fs::is_regular_file(folder / named, ignored)) return folder / named;
  }
  return {};
}

ConfigProblem UnknownFactFile(const FactFile& kind, const std::string& named,
                              const fs::path& mission_folder) {
  std::vector<std::string> known, looked_in;
  std::error_code ignored;
  for (const fs::path& folder : FactFolders(kind, mission_folder)) {
    looked_in.push_back(folder.string());
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
      const fs::path& file = entry.path();
      // Beside a mission lie other .yaml files, too.
      const bool is_one = file.extension() == ".yaml" &&
                          (folder != mission_folder || file.stem().string() == kind.of);
      if (is_one) known.push_back(file.filename().string());
    }
  }
  std::ranges::sort(known);
  const std::string complaint =
      named.empty() ? fmt::format("is missing: which {} is this mission's?", kind.of)
                    : fmt::format("there is no `{}`", named);
  return {.where = {},
          .key = kind.global,
          .text = fmt::format("{}; known: {} (looked in {})", complaint,
                              known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", ")),
                              fmt::join(looked_in, ", "))};
}

std::vector<fs::path> FactFileChain(const FactFile& kind, const fs::path& file) {
  std::vector<fs::path> chain;
  fs::path next = file;
  while (!next.empty() && chain.size() < kMostFactFiles) {
    chain.push_back(next);
    const YAML::Node root = ReadYaml(next);
    if (!root.IsMap() || !root[kBasedOn] || !root[kBasedOn].IsScalar()) break;
    next = FindFactFile(kind, root[kBasedOn].Scalar(), next.parent_path());
  }
  return chain;
}

FactSource FactFor(std::string_view owner, std::string_view key) {
  for (const FactFile* kind : FactFiles()) {
    for (const FactTaker& taker : kind->takers) {
      if (owner == taker.owner && EqualsIgnoringCase(key, taker.key)) return {kind, taker.fact};
    }
  }
  return {};
}

std::vector<ConfigEntry> FactEntries(const FactFile& kind, const fs::path& file) {
  std::vector<ConfigEntry> entries;
  for (const fs::path& one : FactFileChain(kind, file))
    AddEntries(one, entries);
  return entries;
}

void TakeFacts(MissionFile& mission) {
  const std::vector<std::string> former_files = std::move(mission.fact_files);
  mission.fact_files.clear();
  for (ConfigBlock& block : mission.blocks) {
    std::erase_if(block.entries, [&former_files](const ConfigEntry& entry) {
      return std::ranges::find(former_files, entry.where.file) != former_files.end();
    });
  }
  for (const FactFile* kind : FactFiles()) {
    const NamedFile named = ReadNamed(*kind, mission);
    for (const fs::path& one : FactFileChain(*kind, named.file))
      mission.fact_files.push_back(one.string());
    for (ConfigBlock& block : mission.blocks)
      TakeFactsFrom(named, ProgramOfBlock(block, mission), block);
  }
}

}  // namespace limpet
