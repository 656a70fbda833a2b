// SPDX-License-Identifier: MIT
#include "limpet/topics/variable.hpp"

#include <utility>

#include "limpet/core/require.hpp"

namespace limpet {
namespace {

std::map<std::string, Variable>& VariableStore() {
  static std::map<std::string, Variable> catalog;
  return catalog;
}

}  // namespace

const std::map<std::string, Variable>& VariableCatalog() { return VariableStore(); }

void AddToVariableCatalog(Variable variable) {
  const bool is_new = VariableStore().try_emplace(variable.name, variable).second;
  LIMPET_REQUIRE(is_new, "a variable is declared twice");
}

}  // namespace limpet
