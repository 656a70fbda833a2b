// SPDX-License-Identifier: MIT
#include "limpet/app/warning_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/core/letter_case.hpp"

namespace limpet {
namespace {

constexpr std::string_view kSuffix = "_WARNINGS";
constexpr std::string_view kBetweenWarnings = "; ";
constexpr std::string_view kAfterId = ": ";
constexpr std::string_view kBeforeSeverity = " (";
constexpr std::string_view kNoWarnings = "none";

/// Takes ` (severity)` off the end of an id.
Severity TakeSeverity(std::string_view& id) {
  const std::size_t begin = id.rfind(kBeforeSeverity);
  if (begin == std::string_view::npos || !id.ends_with(')')) {
    return Severity::kWarning;
  }
  const std::size_t name = begin + kBeforeSeverity.size();
  const auto severity = SeverityNamed(id.substr(name, id.size() - name - 1));
  if (severity) {
    id = id.substr(0, begin);
  }
  return severity.value_or(Severity::kWarning);
}

}  // namespace

std::string WarningsVariable(std::string_view app) { return UpperCase(app) + std::string(kSuffix); }

bool CarriesWarnings(std::string_view variable) { return variable.ends_with(kSuffix); }

std::string_view AppOfWarnings(std::string_view variable) {
  return variable.substr(0, variable.rfind(kSuffix));
}

std::string EncodeWarnings(const std::map<std::string, StandingWarning>& warnings) {
  std::string text;
  for (const auto& [id, warning] : warnings) {
    std::string part = fmt::format("{} ({}): {}", id, NameOf(warning.severity), warning.text);
    std::ranges::replace(part, ';', ',');
    text += (text.empty() ? "" : std::string(kBetweenWarnings)) + part;
  }
  return text.empty() ? std::string(kNoWarnings) : text;
}

std::map<std::string, ToldWarning> DecodeWarnings(std::string_view text) {
  std::map<std::string, ToldWarning> warnings;
  while (!text.empty() && text != kNoWarnings) {
    const std::string_view part = text.substr(0, text.find(kBetweenWarnings));
    text.remove_prefix(std::min(text.size(), part.size() + kBetweenWarnings.size()));
    const std::size_t end_of_id = part.find(kAfterId);
    const bool has_text = end_of_id != std::string_view::npos;
    std::string_view id = part.substr(0, end_of_id);
    const Severity severity = TakeSeverity(id);
    warnings.try_emplace(
        std::string(id),
        ToldWarning{severity, has_text ? std::string(part.substr(end_of_id + kAfterId.size()))
                                       : std::string()});
  }
  return warnings;
}

}  // namespace limpet
