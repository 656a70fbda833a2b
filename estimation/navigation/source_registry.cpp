// SPDX-License-Identifier: MIT
#include "estimation/navigation/source_registry.hpp"

#include <map>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/require.hpp"

namespace limpet {
namespace {

using SourceMakers = std::map<std::string, std::function<std::unique_ptr<SourceFactory>()>>;

/// Filled before main by the registration lines.
SourceMakers& RegisteredSources() {
  static SourceMakers makers;
  return makers;
}

}  // namespace

std::vector<std::string> SourceNames() {
  std::vector<std::string> names;
  for (const auto& [name, make] : RegisteredSources())
    names.push_back(name);
  return names;
}

Expected<std::unique_ptr<SourceFactory>> FindSource(const std::string& name) {
  const auto found = RegisteredSources().find(name);
  if (found != RegisteredSources().end()) return found->second();
  const std::string nearest = NearestWord(name, SourceNames());
  return Error{fmt::format("no measurement source `{}`{}", name,
                           nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest))};
}

void RegisterSource(const std::string& name,
                    std::function<std::unique_ptr<SourceFactory>()> make_factory) {
  const bool is_new = RegisteredSources().emplace(name, std::move(make_factory)).second;
  LIMPET_REQUIRE(is_new, "two measurement sources are registered as " + name);
}

}  // namespace limpet
