// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace limpet {

/// The text of a mission or behavior file with its plugs in place; as it is if it has none. Throws
/// ConfigError.
[[nodiscard]] std::string ExpandedText(std::string_view text, const std::filesystem::path& file);

}  // namespace limpet
