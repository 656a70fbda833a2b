// SPDX-License-Identifier: MIT
#include "limpet/tuning/setting_diff.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"
#include "limpet/mission/source_text.hpp"
#include "limpet/tuning/tuned_place.hpp"
#include "limpet/tuning/unified_diff.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

/// Edits by file, as the mission names it.
using FileEdits = std::map<std::string, std::vector<LineEdit>>;

std::string LineAt(const SourceLine& where) {
  return SplitLines(ReadTextFile(where.file), where.file)
      .at(static_cast<std::size_t>(where.line) - 1)
      .text;
}

/// The line with another value; what stands before the value and a comment behind it stay.
std::string WithValue(const std::string& line, const std::string& value) {
  const std::size_t equals = line.find('=');
  std::size_t begin = line.find_first_not_of(" \t", equals + 1);
  if (begin == std::string::npos) begin = line.size();
  const std::size_t comment = line.find("//", begin);
  std::string text = line.substr(0, begin) + value;
  if (begin == equals + 1) text = line.substr(0, begin) + " " + value;
  return comment == std::string::npos ? text : text + "  " + line.substr(comment);
}

/// The line behind which a block's first entry goes: of its `name`, else of its brace.
SourceLine HeadOf(const TunedPlace& place) {
  const bool has_name = place.name_line.line > 0 && place.name_line.file == place.block.file;
  if (has_name) return place.name_line;
  const std::vector<TextLine> lines = SplitLines(ReadTextFile(place.block.file), place.block.file);
  for (std::size_t i = static_cast<std::size_t>(place.block.line) - 1; i < lines.size(); ++i) {
    if (lines[i].text.find('{') != std::string::npos) return lines[i].where;
  }
  return place.block;
}

/// An entry of a block that the mission has.
void AddEdit(const TunedPlace& place, const std::string& value, FileEdits& edits) {
  if (place.entry.line > 0) {
    edits[place.entry.file].push_back(
        {.line = place.entry.line, .text = WithValue(LineAt(place.entry), value)});
    return;
  }
  const SourceLine head = HeadOf(place);
  edits[head.file].push_back(
      {.line = head.line, .text = fmt::format("  {} = {}", place.key, value), .is_inserted = true});
}

/// A block that the mission has not, at its end.
void AddBlock(const std::string& owner, const std::vector<std::string>& entries,
              const std::string& mission_file, FileEdits& edits) {
  const auto last = static_cast<int>(SplitLines(ReadTextFile(mission_file), mission_file).size());
  std::vector<std::string> lines{fmt::format("ProcessConfig = {}", owner), "{"};
  lines.insert(lines.end(), entries.begin(), entries.end());
  lines.emplace_back("}");
  for (const std::string& line : lines)
    edits[mission_file].push_back({.line = last, .text = line, .is_inserted = true});
}

fs::path Canonical(const fs::path& file) { return fs::weakly_canonical(fs::absolute(file)); }

/// The deepest folder that holds both.
fs::path CommonFolder(const fs::path& a, const fs::path& b) {
  fs::path common;
  auto of_a = a.begin();
  auto of_b = b.begin();
  for (; of_a != a.end() && of_b != b.end() && *of_a == *of_b; ++of_a, ++of_b)
    common /= *of_a;
  return common;
}

}  // namespace

SettingDiff DiffOf(const MissionReading& mission, const ParameterSpace& space,
                   const SettingValues& values) {
  FileEdits edits;
  std::map<std::string, std::vector<std::string>> new_blocks;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const TunedPlace place = FindTunedPlace(mission, space.parameters()[i].name);
    const std::string value = TextOf(values[i]);
    if (ParseNumber(place.value) == ParseNumber(value)) continue;
    if (place.block.line > 0) {
      AddEdit(place, value, edits);
    } else {
      new_blocks[place.owner].push_back(fmt::format("  {} = {}", place.key, value));
    }
  }
  for (const auto& [owner, entries] : new_blocks)
    AddBlock(owner, entries, mission.mission().file, edits);
  SettingDiff diff{.root = Canonical(mission.folder())};
  for (const auto& [file, changes] : edits)
    diff.root = CommonFolder(diff.root, Canonical(file).parent_path());
  for (const auto& [file, changes] : edits) {
    diff.files.push_back(Canonical(file).lexically_relative(diff.root).generic_string());
    diff.text += UnifiedDiff(diff.files.back(), ReadTextFile(file), changes);
  }
  return diff;
}

}  // namespace limpet
