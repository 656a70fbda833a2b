// SPDX-License-Identifier: MIT
#include "limpet/helm/settings_text.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace limpet {
namespace {

/// The last line of a block for `spec`, by any of its names; else the default.
std::string TextInForce(const ConfigBlock& block, const ParamSpec& spec) {
  std::string text = spec.example.empty() ? "" : spec.example.back();
  for (const ConfigEntry& entry : block.entries) {
    const bool is_other_name = std::ranges::any_of(
        spec.aliases, [&entry](const auto& alias) { return EqualsIgnoringCase(alias, entry.key); });
    if (is_other_name || EqualsIgnoringCase(spec.name, entry.key)) text = entry.value;
  }
  return text;
}

}  // namespace

std::string SettingsText(const ConfigBlock& block, const std::string& name,
                         const std::vector<ParamSpec>& specs) {
  std::string line = fmt::format("type={},name={}", block.name, name);
  for (const ParamSpec& spec : specs) {
    if (spec.is_repeatable || spec.is_without_effect) continue;
    const std::string text = TextInForce(block, spec);
    if (text.empty()) continue;
    const bool has_commas = text.find(',') != std::string::npos && text.front() != '"';
    line += fmt::format(",{}={}", spec.name, has_commas ? '"' + text + '"' : text);
  }
  return line;
}

}  // namespace limpet
