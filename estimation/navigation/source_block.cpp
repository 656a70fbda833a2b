// SPDX-License-Identifier: MIT
#include "estimation/navigation/source_block.hpp"

#include <algorithm>
#include <iterator>

#include "estimation/navigation/measurement_source.hpp"

namespace limpet {
namespace {

std::vector<std::string> NamesIn(const ConfigEntry& entry) {
  std::vector<std::string> names;
  for (const std::string& part : Split(entry.value, ',')) {
    const std::string name(Trim(part));
    if (!name.empty() && !EqualsIgnoringCase(name, "none")) names.push_back(name);
  }
  return names;
}

}  // namespace

std::vector<ParamSpec> PrefixedKeys(const std::string& name, SourceFactory& factory) {
  std::vector<ParamSpec> specs = factory.Parameters();
  for (ParamSpec& spec : specs)
    spec.name = name + "_" + spec.name;
  return specs;
}

SourceBlock::SourceBlock(const ConfigBlock& block) {
  const ConfigEntry* entry = block.Find("sources");
  for (const std::string& name : entry != nullptr ? NamesIn(*entry) : std::vector<std::string>()) {
    const bool is_twice =
        std::ranges::count(sources, name, [](const auto& s) { return s.first; }) > 0;
    auto found = FindSource(name);
    if (is_twice || !found) {
      const std::string why = found ? "`" + name + "` stands there twice" : found.error().text;
      problems.push_back({.where = entry->where, .key = entry->key, .text = why});
      continue;
    }
    sources.emplace_back(name, *std::move(found));
    std::ranges::move(PrefixedKeys(name, *sources.back().second), std::back_inserter(specs));
  }
}

NamedSources ParseSources(std::string_view text) {
  const SourceLine where{.file = "--sources", .line = 1};
  ConfigBlock block{.name = "sources", .where = where, .entries = {}};
  for (const std::string& part : Split(text, ';')) {
    const std::string_view line = Trim(part);
    const std::size_t equals = line.find('=');
    if (block.entries.empty()) {
      block.entries.push_back({.key = "sources", .value = std::string(line), .where = where});
    } else if (equals != std::string_view::npos) {
      block.entries.push_back({.key = std::string(Trim(line.substr(0, equals))),
                               .value = std::string(Trim(line.substr(equals + 1))),
                               .where = where});
    } else if (!line.empty()) {
      block.problems.push_back(
          {.where = where, .key = std::string(line), .text = "is no key = value"});
    }
  }
  SourceBlock read(block);
  std::vector<ConfigProblem> problems = ApplyBlock(block, read.specs, {"sources"});
  std::ranges::move(read.problems, std::back_inserter(problems));
  if (!problems.empty()) throw ConfigError(problems);
  return std::move(read.sources);
}

}  // namespace limpet
