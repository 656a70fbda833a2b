// SPDX-License-Identifier: MIT
#include "limpet/topics/bid.hpp"

#include <fmt/format.h>

#include "limpet/core/config.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {

std::string WhyText(const Bid& bid) {
  if (bid.veto) return *bid.veto;
  std::string text;
  for (const Reason& reason : bid.why) {
    text += fmt::format("{}{}={:.2f}", text.empty() ? "" : " ", reason.name, reason.value);
  }
  return text;
}

std::vector<Reason> ReasonsIn(std::string_view line) {
  std::vector<Reason> reasons;
  for (const std::string& word : Split(line, ' ')) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) continue;
    if (const auto value = ParseNumber(std::string_view(word).substr(equals + 1))) {
      reasons.push_back({.name = word.substr(0, equals), .value = *value});
    }
  }
  return reasons;
}

}  // namespace limpet
