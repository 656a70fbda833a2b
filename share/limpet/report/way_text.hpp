// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <fmt/format.h>

namespace limpet {

/// After how much way something was so: `312 m`, or `never`.
[[nodiscard]] inline std::string WayText(const std::optional<double>& metres) {
  return metres ? fmt::format("{:.0f} m", *metres) : "never";
}

}  // namespace limpet
