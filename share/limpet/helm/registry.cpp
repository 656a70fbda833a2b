// SPDX-License-Identifier: MIT
#include "limpet/helm/registry.hpp"

namespace limpet {

std::map<std::string, BehaviorEntry>& BehaviorRegistry() {
  static std::map<std::string, BehaviorEntry> registry;
  return registry;
}

}  // namespace limpet
