// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limpet/core/params.hpp"
#include "limpet/safety/safety_ladder.hpp"

namespace limpet {

/// `<rule>_hold_s`, the key of the block that says how long the rule waits; empty: it does not.
[[nodiscard]] std::string HoldKeyOf(const SafetyRule& rule);

/// The block of pSafety: limits and hold times of the table's rules, and those to do without.
struct SafetyParams {
  SafetySettings settings;
  std::vector<std::string> off;

  template <class Visitor>
  void Describe(Visitor& visit) {
    for (const SafetyRule& rule : SafetyRules()) {
      const auto index = static_cast<std::size_t>(rule.id);
      if (!rule.limit.key.empty()) {
        visit(std::string(rule.limit.key).c_str(), settings.limits[index], LimitHelp(rule).c_str(),
              InRange(rule.limit.least, rule.limit.most));
      }
      if (const std::string key = HoldKeyOf(rule); !key.empty()) {
        visit(key.c_str(), settings.holds[index],
              ("Rule " + std::string(rule.name) + " waits so long beyond its limit").c_str(),
              InRange(Seconds(0.0), Seconds(3600.0)));
      }
    }
    visit("off", off, "A rule that this mission does without, by name");
  }
  /// The settings, with the rules switched off. Throws ConfigError for one that does not exist.
  [[nodiscard]] SafetySettings Applied(const std::string& app) const;

 private:
  static std::string LimitHelp(const SafetyRule& rule);
};

}  // namespace limpet
