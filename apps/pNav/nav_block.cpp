// SPDX-License-Identifier: MIT
#include "apps/pNav/nav_block.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "apps/pNav/class_radii.hpp"
#include "estimation/navigation/measurement_source.hpp"
#include "estimation/navigation/source_block.hpp"
#include "limpet/app/registry.hpp"

namespace limpet {
namespace {

/// MOOS's keys; where a source is unknown, those of all sources too: one slip is one problem.
std::vector<std::string> KeysOfOthers(bool are_all_known) {
  std::vector<std::string> keys = CommonAppKeys();
  for (const std::string& name : are_all_known ? std::vector<std::string>() : SourceNames()) {
    auto factory = *FindSource(name);
    std::ranges::transform(PrefixedKeys(name, *factory), std::back_inserter(keys),
                           &ParamSpec::name);
  }
  return keys;
}

}  // namespace

NavBlock::NavBlock(const ConfigBlock& block) {
  std::vector<ParamSpec> specs = DescribeParams(params);
  SourceBlock named(block);
  std::ranges::move(named.specs, std::back_inserter(specs));
  sources = std::move(named.sources);
  sensors = std::move(named.sensors);
  const bool has_own_compass = std::ranges::any_of(
      sources, [](const auto& source) { return source.first == "magnetic_heading"; });
  problems = ApplyBlock(block, specs, KeysOfOthers(named.problems.empty()));
  params.compass_aids = params.compass_aids && !has_own_compass;
  if (const auto radii = ParseClassRadii(params.opi_radius_by_class); !radii) {
    const ConfigEntry* stated = block.Find("opi_radius_by_class");
    problems.push_back({.where = stated != nullptr ? stated->where : block.where,
                        .key = "opi_radius_by_class",
                        .text = radii.error().text});
  }
  std::ranges::move(named.problems, std::back_inserter(problems));
}

std::vector<ConfigProblem> CheckNavBlock(const ConfigBlock& block) {
  std::vector<ConfigProblem> problems = CheckCommonAppKeys(block);
  std::ranges::move(NavBlock(block).problems, std::back_inserter(problems));
  return problems;
}

std::unique_ptr<App> CreateNavApp(const AppContext& context, const ConfigBlock& block) {
  const NavBlock read(block);
  if (!read.problems.empty()) throw ConfigError(read.problems);
  auto app = std::make_unique<NavApp>(context, read.params);
  for (const NamedSources* heard : {&read.sensors, &read.sources}) {
    for (const auto& [name, factory] : *heard)
      app->Hear(name, factory->Make());
  }
  return app;
}

}  // namespace limpet
