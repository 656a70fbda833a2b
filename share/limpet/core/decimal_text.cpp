// SPDX-License-Identifier: MIT
#include "limpet/core/decimal_text.hpp"

#include <cmath>

#include <fmt/format.h>

namespace limpet {

std::string DecimalText(double value, int decimals) {
  if (!std::isfinite(value)) {
    return "0";
  }
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) {
      text.pop_back();
    }
  }
  return text == "-0" ? "0" : text;
}

}  // namespace limpet
