// SPDX-License-Identifier: MIT
// How numbers of a report are said.
#pragma once

#include <optional>
#include <string>

#include <fmt/format.h>

namespace limpet {

/// Three digits; never 0.000 or 1.000, because nothing is certain.
[[nodiscard]] inline std::string ProbabilityText(double probability) {
  if (probability >= 0.9995) return ">0.999";
  if (probability < 0.0005) return "<0.001";
  return fmt::format("{:.3f}", probability);
}

/// `-` for what nobody can say.
[[nodiscard]] inline std::string ProbabilityText(const std::optional<double>& probability) {
  return probability ? ProbabilityText(*probability) : "-";
}

/// `0.31 m`; `unknown` for what nobody measured.
[[nodiscard]] inline std::string MetresText(const std::optional<double>& metres) {
  return metres ? fmt::format("{:.2f} m", *metres) : "unknown";
}

/// One decimal; `unknown` for what nobody measured.
[[nodiscard]] inline std::string NumberText(const std::optional<double>& number) {
  return number ? fmt::format("{:.1f}", *number) : "unknown";
}

}  // namespace limpet
