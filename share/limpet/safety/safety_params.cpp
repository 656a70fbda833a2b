// SPDX-License-Identifier: MIT
#include "limpet/safety/safety_params.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace limpet {

std::string HoldKeyOf(const SafetyRule& rule) {
  return rule.hold > Seconds(0.0) ? std::string(rule.name) + "_hold_s" : "";
}

std::string SafetyParams::LimitHelp(const SafetyRule& rule) {
  return fmt::format("Rule {}, {} the limit [{}]: {}", rule.name,
                     rule.side == SafetyRule::Side::kAbove ? "above" : "below", rule.limit.unit,
                     rule.meaning);
}

SafetySettings SafetyParams::Applied(const std::string& app) const {
  SafetySettings applied = settings;
  std::vector<ConfigProblem> problems;
  for (const std::string& name : off) {
    const auto rule = std::ranges::find(SafetyRules(), name, &SafetyRule::name);
    if (rule != SafetyRules().end()) {
      applied.is_off[static_cast<std::size_t>(rule->id)] = true;
      continue;
    }
    std::vector<std::string> known;
    for (const SafetyRule& other : SafetyRules()) {
      known.emplace_back(other.name);
    }
    problems.push_back(
        {{},
         app + " off",
         fmt::format("no safety rule `{}`; nearest known: `{}`", name, NearestWord(name, known))});
  }
  if (!problems.empty()) throw ConfigError(problems);
  return applied;
}

}  // namespace limpet
