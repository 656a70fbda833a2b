// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <fmt/format.h>

namespace limpet {

/// Three digits; never 0.000 or 1.000, because nothing is certain.
[[nodiscard]] inline std::string ProbabilityText(double probability) {
  if (probability >= 0.9995) return ">0.999";
  if (probability < 0.0005) return "<0.001";
  return fmt::format("{:.3f}", probability);
}

}  // namespace limpet
