// SPDX-License-Identifier: MIT
#include "limpet/helm/behavior_templates.hpp"

#include <algorithm>

#include "limpet/helm/behavior_update.hpp"

namespace limpet {

void BehaviorTemplates::Add(const ConfigBlock& block, const CommonSettings& settings) {
  const int most = settings.max_spawnings;
  templates_.push_back({.block = block,
                        .name = settings.name,
                        .variable = settings.updates_variable,
                        .left = most > 0 ? std::optional(most) : std::nullopt});
}

std::vector<SpawnRequest> BehaviorTemplates::RequestsOf(std::string_view variable,
                                                        const std::string& text,
                                                        const IsTaken& is_taken) {
  std::vector<SpawnRequest> requests;
  for (Template& made_from : templates_) {
    if (made_from.variable != variable || made_from.left == 0) {
      continue;
    }
    const BehaviorUpdate update = ParseUpdate(text, made_from.variable);
    if (!update.name || update.name->empty() || is_taken(*update.name) ||
        is_taken(made_from.name + *update.name)) {
      continue;
    }
    ConfigBlock block = made_from.block;
    for (const ConfigEntry& part : update.parts) {
      PutInto(block, part, IsRepeatableCommonKey(part.key));
    }
    PutInto(block, {"name", made_from.name + *update.name, {.file = made_from.variable, .line = 0}},
            false);
    if (made_from.left) --*made_from.left;
    requests.push_back({.block = std::move(block), .base_name = made_from.name});
  }
  return requests;
}

std::vector<std::string> BehaviorTemplates::Variables() const {
  std::vector<std::string> names;
  std::ranges::transform(templates_, std::back_inserter(names), &Template::variable);
  return names;
}

}  // namespace limpet
