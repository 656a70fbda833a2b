// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/community.hpp"

#include "limpet/console/tools.hpp"

namespace limpet {

int RunScopeVerb(std::span<const std::string> args) { return RunScope("limpet scope", args); }
int RunPokeVerb(std::span<const std::string> args) { return RunPoke("limpet poke", args); }
int RunPlayVerb(std::span<const std::string> args) { return RunPlay("limpet play", args); }
int RunStatusVerb(std::span<const std::string> args) { return RunStatus("limpet status", args); }

}  // namespace limpet
