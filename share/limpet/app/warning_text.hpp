// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace limpet {

/// Standing warnings as <APP>_WARNINGS carries them: `ID: text; ID: text`, or `none`. A semicolon
/// in a text becomes a comma, so that the list can be taken apart again.
[[nodiscard]] std::string EncodeWarnings(const std::map<std::string, std::string>& warnings);
/// Ids and texts. What has no `: ` is taken for an id without a text.
[[nodiscard]] std::map<std::string, std::string> DecodeWarnings(std::string_view text);

}  // namespace limpet
