// SPDX-License-Identifier: MIT
#include "limpet/vision/detector_registry.hpp"

#include <iterator>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/require.hpp"

namespace limpet {
namespace {

using Registry = std::map<std::string, std::function<std::unique_ptr<DetectorFactory>()>>;

/// Filled before main by the registration lines.
Registry& RegisteredDetectors() {
  static Registry registry;
  return registry;
}

}  // namespace

std::vector<std::string> DetectorNames() {
  std::vector<std::string> names;
  std::ranges::transform(RegisteredDetectors(), std::back_inserter(names),
                         &Registry::value_type::first);
  return names;
}

Expected<std::unique_ptr<DetectorFactory>> FindDetector(const std::string& name) {
  const auto found = RegisteredDetectors().find(name);
  if (found != RegisteredDetectors().end()) {
    return found->second();
  }
  const std::string nearest = NearestWord(name, DetectorNames());
  return Error{fmt::format("no detector `{}`{}", name,
                           nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest))};
}

std::unique_ptr<Detector> MakeDetector(const std::string& name) {
  const auto factory = FindDetector(name);
  LIMPET_REQUIRE(factory, factory.error().text);
  return (*factory)->Make();
}

void RegisterDetector(const std::string& name,
                      std::function<std::unique_ptr<DetectorFactory>()> make_factory) {
  const bool is_new = RegisteredDetectors().emplace(name, std::move(make_factory)).second;
  LIMPET_REQUIRE(is_new, "two detectors are registered as " + name);
}

}  // namespace limpet
