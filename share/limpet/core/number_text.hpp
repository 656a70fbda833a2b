// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace limpet {

/// Shortest text that reads back to the same double.
[[nodiscard]] std::string TextOf(double value);

/// The whole text as a finite number, or nothing.
[[nodiscard]] std::optional<double> ParseNumber(std::string_view text);
[[nodiscard]] std::optional<std::int64_t> ParseInteger(std::string_view text);
/// true/false, yes/no, on/off (any case) or a number (> 0 is true), as MOOS reads them.
[[nodiscard]] std::optional<bool> ParseFlag(std::string_view text);

}  // namespace limpet
