// SPDX-License-Identifier: MIT
// Keys of a YAML file, section by section, as lists and tables.
#pragma once

#include <string>
#include <vector>

#include "limpet/core/key_section.hpp"

namespace limpet {

[[nodiscard]] std::string KeysText(const std::vector<KeySection>& sections);
[[nodiscard]] std::string KeysJson(const std::vector<KeySection>& sections);
[[nodiscard]] std::string KeysMarkdown(const std::vector<KeySection>& sections);

}  // namespace limpet
