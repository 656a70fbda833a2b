// SPDX-License-Identifier: MIT
#include "limpet/helm/registry.hpp"

namespace limpet {

std::map<std::string, BehaviorEntry>& BehaviorRegistry() {
  static std::map<std::string, BehaviorEntry> registry;
  return registry;
}

const std::vector<std::string>& CommonBehaviorKeys() {
  static const std::vector<std::string> keys{"name",     "pwt",      "priority",   "condition",
                                             "runflag",  "runxflag", "activeflag", "inactiveflag",
                                             "idleflag", "updates"};
  return keys;
}

}  // namespace limpet
