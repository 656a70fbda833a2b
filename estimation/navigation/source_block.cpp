// SPDX-License-Identifier: MIT
#include "estimation/navigation/source_block.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

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
  const ConfigEntry usual{.key = "sensors", .value = kUsualSensors, .where = block.where};
  const ConfigEntry* named = block.Find(usual.key);
  Read(named != nullptr ? *named : usual, true);
  if (const ConfigEntry* further = block.Find("sources")) Read(*further, false);
}

SourceBlock SourceBlock::OfSourcesAlone(const ConfigBlock& block) {
  SourceBlock alone;
  if (const ConfigEntry* further = block.Find("sources")) alone.Read(*further, false);
  return alone;
}

void SourceBlock::Read(const ConfigEntry& entry, bool are_of_motion) {
  NamedSources& read = are_of_motion ? sensors : sources;
  for (const std::string& name : NamesIn(entry)) {
    const auto is_it = [&name](const auto& other) { return other.first == name; };
    const auto problem = [this, &entry](std::string why) {
      problems.push_back({.where = entry.where, .key = entry.key, .text = std::move(why)});
    };
    auto found = FindSource(name);
    if (!found) {
      problem(found.error().text);
    } else if ((*found)->is_of_motion() != are_of_motion) {
      problem(fmt::format("`{}` is {}: `{}` names it", name,
                          are_of_motion ? "none that dead reckoning stands on"
                                        : "one that dead reckoning stands on",
                          are_of_motion ? "sources" : "sensors"));
    } else if (std::ranges::any_of(read, is_it)) {
      problem("`" + name + "` stands there twice");
    } else {
      read.emplace_back(name, *std::move(found));
      std::ranges::move(PrefixedKeys(name, *read.back().second), std::back_inserter(specs));
    }
  }
}

std::unique_ptr<MotionSensor> TakeMotionSensor(std::unique_ptr<MeasurementSource>& source) {
  auto* sensor = dynamic_cast<MotionSensor*>(source.get());
  if (sensor != nullptr) static_cast<void>(source.release());
  return std::unique_ptr<MotionSensor>(sensor);
}

std::vector<std::unique_ptr<MotionSensor>> UsualSensors() {
  std::vector<std::unique_ptr<MotionSensor>> sensors;
  for (const auto& [name, factory] : SourceBlock(ConfigBlock{}).sensors) {
    auto source = factory->Make();
    sensors.push_back(TakeMotionSensor(source));
  }
  return sensors;
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
  SourceBlock read = SourceBlock::OfSourcesAlone(block);
  std::vector<ConfigProblem> problems = ApplyBlock(block, read.specs, {"sources"});
  std::ranges::move(read.problems, std::back_inserter(problems));
  if (!problems.empty()) throw ConfigError(problems);
  return std::move(read.sources);
}

}  // namespace limpet
