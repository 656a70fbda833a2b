// SPDX-License-Identifier: MIT
#include "limpet/tuning/tuned_place.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "limpet/app/registry.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/mission/mission_lines.hpp"

namespace limpet {
namespace {

constexpr const char* kWeightKey = "pwt";
constexpr const char* kDefaultWeight = "100";

/// The line in a file that says the key itself: what a block takes from a global stands elsewhere.
SourceLine LineOf(const ConfigEntry& entry) {
  if (entry.where.line == 0 || !std::filesystem::is_regular_file(entry.where.file)) return {};
  const std::vector<TextLine> lines = SplitLines(ReadTextFile(entry.where.file), entry.where.file);
  const auto index = static_cast<std::size_t>(entry.where.line) - 1;
  if (index >= lines.size()) return {};
  const KeyValue said = SplitKeyValue(lines[index].text);
  return EqualsIgnoringCase(said.key, entry.key) ? entry.where : SourceLine{};
}

[[noreturn]] void ComplainOfKey(const std::string& name, const std::string& key,
                                const std::vector<ParamSpec>& specs) {
  std::vector<std::string> known;
  std::ranges::transform(specs, std::back_inserter(known), &ParamSpec::name);
  const std::string nearest = NearestWord(key, known);
  throw ConfigError(
      {{},
       name,
       fmt::format("no parameter `{}`{}", key,
                   nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest))});
}

void ReadBlock(const ConfigBlock& block, const std::vector<ParamSpec>& specs, TunedPlace& place) {
  place.block = block.where;
  const bool is_weight = place.is_behavior && EqualsIgnoringCase(place.key, kWeightKey);
  const auto spec = std::ranges::find_if(
      specs, [&](const ParamSpec& each) { return EqualsIgnoringCase(each.name, place.key); });
  if (spec == specs.end() && !is_weight) {
    ComplainOfKey(place.owner + "." + place.key, place.key, specs);
  }
  place.value = is_weight ? kDefaultWeight : spec->default_text;
  // The last line of a key counts.
  for (const ConfigEntry& entry : block.entries) {
    if (!EqualsIgnoringCase(entry.key, place.key)) continue;
    place.value = entry.value;
    place.entry = LineOf(entry);
  }
  if (const ConfigEntry* name = block.Find("name")) place.name_line = LineOf(*name);
  if (const ConfigEntry* updates = block.Find("updates")) place.updates = updates->value;
}

}  // namespace

TunedPlace FindTunedPlace(const MissionReading& mission, const std::string& name) {
  const std::size_t dot = name.find('.');
  TunedPlace place{.owner = name.substr(0, dot),
                   .key = dot == std::string::npos ? "" : name.substr(dot + 1)};
  if (const auto app = AppRegistry().find(place.owner); app != AppRegistry().end()) {
    const ConfigBlock* block = mission.mission().Block(place.owner);
    ReadBlock(block != nullptr ? *block : ConfigBlock{}, app->second.describe(), place);
    return place;
  }
  std::vector<std::string> known;
  for (const BehaviorFile& file : mission.behavior_files()) {
    for (const ConfigBlock& block : file.behaviors) {
      known.push_back(BehaviorNameOf(block));
      if (known.back() != place.owner) continue;
      place.is_behavior = true;
      const auto kind = BehaviorRegistry().find(block.name);
      const bool is_known = kind != BehaviorRegistry().end();
      ReadBlock(block, is_known ? kind->second.describe() : std::vector<ParamSpec>{}, place);
      return place;
    }
  }
  const std::string nearest = NearestWord(place.owner, known);
  throw ConfigError(
      {{},
       name,
       fmt::format("no app or behavior `{}` in this mission{}", place.owner,
                   nearest.empty() ? fmt::format("; behaviors: {}", fmt::join(known, ", "))
                                   : fmt::format("; did you mean `{}`?", nearest))});
}

}  // namespace limpet
