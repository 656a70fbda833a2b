// SPDX-License-Identifier: MIT
#include "limpet/helm/generator_registry.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "limpet/core/config.hpp"

namespace limpet {
namespace {

GeneratorMap CopyOf(const GeneratorMap& plans) {
  GeneratorMap copy;
  for (const auto& [name, plan] : plans) {
    copy.emplace(name, plan->Clone());
  }
  return copy;
}

}  // namespace

GeneratorMap& GeneratorRegistry() {
  static GeneratorMap registry;
  return registry;
}

std::vector<std::string> NamesOfGenerators(std::string_view list) {
  std::vector<std::string> names;
  for (const std::string& word : Split(list, ',')) {
    names.emplace_back(Trim(word));
  }
  std::erase(names, "");
  return names;
}

std::string UnknownGenerator(const std::string& name) {
  std::vector<std::string> known;
  std::ranges::transform(GeneratorRegistry(), std::back_inserter(known),
                         [](const auto& entry) { return entry.first; });
  return fmt::format("no generator `{}`; there are: {}", name, fmt::join(known, ", "));
}

GeneratorParams::GeneratorParams() : plans_(CopyOf(GeneratorRegistry())) {}
GeneratorParams::GeneratorParams(const GeneratorParams& other) : plans_(CopyOf(other.plans_)) {}
GeneratorParams& GeneratorParams::operator=(const GeneratorParams& other) {
  if (this != &other) {
    plans_ = CopyOf(other.plans_);
  }
  return *this;
}

void GeneratorParams::Describe(ParamCollector& visit) {
  for (const auto& [name, plan] : plans_) {
    plan->Describe(visit);
  }
}

std::vector<std::unique_ptr<OptionGenerator>> GeneratorParams::Build(std::string_view names,
                                                                     const Random& random) const {
  std::vector<std::unique_ptr<OptionGenerator>> generators;
  for (const std::string& name : NamesOfGenerators(names)) {
    const auto plan = plans_.find(name);
    if (plan == plans_.end()) {
      throw ConfigError(
          ConfigProblem{{.file = "pHelm", .line = 0}, "generators", UnknownGenerator(name)});
    }
    generators.push_back(plan->second->Build(random));
  }
  return generators;
}

}  // namespace limpet
