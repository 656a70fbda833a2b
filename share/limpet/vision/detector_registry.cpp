// SPDX-License-Identifier: MIT
#include "limpet/vision/detector_registry.hpp"

#include <utility>

namespace limpet {
namespace {

/// Filled before main by the registration lines.
FactoryRegistry<DetectorFactory>& RegisteredDetectors() {
  static FactoryRegistry<DetectorFactory> registry("detector");
  return registry;
}

}  // namespace

std::vector<std::string> DetectorNames() { return RegisteredDetectors().Names(); }

Expected<std::unique_ptr<DetectorFactory>> FindDetector(const std::string& name) {
  return RegisteredDetectors().Find(name);
}

std::unique_ptr<Detector> MakeDetector(const std::string& name) {
  const auto factory = FindDetector(name);
  LIMPET_REQUIRE(factory, factory.error().text);
  return (*factory)->Make();
}

void RegisterDetector(const std::string& name,
                      std::function<std::unique_ptr<DetectorFactory>()> make_factory) {
  RegisteredDetectors().Add(name, std::move(make_factory));
}

}  // namespace limpet
