// SPDX-License-Identifier: MIT
#include "limpet/shapes/visual_hints.hpp"

#include "limpet/core/config.hpp"
#include "limpet/core/letter_case.hpp"
#include "limpet/core/number_text.hpp"

namespace limpet {

bool VisualHints::Add(std::string_view line) {
  std::map<std::string, std::string, std::less<>> added;
  for (const std::string& part : Split(line, ',')) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos) return false;
    std::string name = LowerCase(Trim(std::string_view(part).substr(0, equals)));
    const std::string value(Trim(std::string_view(part).substr(equals + 1)));
    if (name.empty() || value.empty()) return false;
    constexpr std::string_view kShort = "lcolor";
    if (name.ends_with(kShort)) {
      name.replace(name.size() - kShort.size(), kShort.size(), "label_color");
    }
    added[name] = value;
  }
  for (auto& [name, value] : added) {
    hints_[name] = std::move(value);
  }
  return true;
}

std::string VisualHints::Text(std::string_view name, std::string_view otherwise) const {
  const auto found = hints_.find(name);
  return found == hints_.end() ? std::string(otherwise) : found->second;
}

double VisualHints::Number(std::string_view name, double otherwise) const {
  return ParseNumber(Text(name, "")).value_or(otherwise);
}

}  // namespace limpet
