// SPDX-License-Identifier: MIT
#include "estimation/navigation/source_registry.hpp"

#include <utility>

namespace limpet {
namespace {

/// Filled before main by the registration lines.
FactoryRegistry<SourceFactory>& RegisteredSources() {
  static FactoryRegistry<SourceFactory> registry("measurement source");
  return registry;
}

}  // namespace

std::vector<std::string> SourceNames() { return RegisteredSources().Names(); }

Expected<std::unique_ptr<SourceFactory>> FindSource(const std::string& name) {
  return RegisteredSources().Find(name);
}

void RegisterSource(const std::string& name,
                    std::function<std::unique_ptr<SourceFactory>()> make_factory) {
  RegisteredSources().Add(name, std::move(make_factory));
}

}  // namespace limpet
