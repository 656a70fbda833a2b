// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace limpet {

/// What scenario.yaml can say that the vehicle's data sheets do not, section by section, as its
/// reader declares it.
[[nodiscard]] std::string ScenarioKeysText();
/// What may fail on demand, for a terminal.
[[nodiscard]] std::string FaultsText();
[[nodiscard]] std::string ScenarioKeysJson();
/// The page docs/scenario-file.md.
[[nodiscard]] std::string ScenarioKeysMarkdown();

}  // namespace limpet
