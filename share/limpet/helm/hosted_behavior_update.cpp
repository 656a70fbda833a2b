// SPDX-License-Identifier: MIT
// What mail changes of a behavior.
#include <algorithm>

#include <fmt/format.h>

#include "limpet/helm/hosted_behavior.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/helm/toggled_switches.hpp"

namespace limpet {
namespace {

/// Adds a line to others of its key, where several are allowed.
bool Adds(const ConfigBlock& block, const ConfigEntry& part) {
  if (IsRepeatableCommonKey(part.key)) return true;
  const std::vector<ParamSpec> specs = BehaviorRegistry().at(block.name).describe();
  const auto spec = std::ranges::find_if(
      specs, [&part](const ParamSpec& known) { return EqualsIgnoringCase(known.name, part.key); });
  return spec != specs.end() && spec->is_repeatable;
}

}  // namespace

void HostedBehavior::Hear(const std::string& variable, const Value& value) {
  if (clock_.IsResetBy(variable, value)) {
    clock_.Reset();
    Call([this] { behavior_->Restart(); });
  }
}

bool HostedBehavior::IsMeant(const BehaviorUpdate& update) const {
  return !update.name || *update.name == name() ||
         (spawn_base_ && *spawn_base_ + *update.name == name());
}

std::optional<std::string> HostedBehavior::TryPart(const ConfigEntry& part,
                                                   ConfigBlock& block) const {
  ConfigBlock changed = block;
  PutInto(changed, WithoutToggle(part, block), Adds(block, part));
  std::vector<ConfigProblem> problems;
  static_cast<void>(ReadCommonSettings(changed, problems));
  try {
    static_cast<void>(Make(changed));
  } catch (const ConfigError& error) {
    problems.insert(problems.end(), error.problems().begin(), error.problems().end());
  }
  if (!problems.empty()) {
    return problems.front().Format();
  }
  block = std::move(changed);
  return std::nullopt;
}

UpdateOutcome HostedBehavior::ApplyUpdate(const std::string& text) {
  const BehaviorUpdate update = ParseUpdate(text, settings_.updates_variable);
  if (!IsMeant(update)) return {.result = "name_mismatch"};
  if (text == last_update_ && !MayRepeat(text)) return {.result = "duplicate"};
  ConfigBlock block = block_;
  std::string names, reasons;
  BehaviorUpdate good{.name = update.name, .parts = {}};
  for (const ConfigEntry& part : update.parts) {
    if (const auto complaint = TryPart(part, block)) {
      names += (names.empty() ? "" : ",") + part.key;
      reasons += (reasons.empty() ? "" : "; ") + *complaint;
    } else {
      good.parts.push_back(part);
    }
  }
  if (!good.parts.empty()) {
    Rebuild(block, good);
  }
  if (names.empty()) {
    ++good_updates_;
    last_update_ = text;
    return {.result = "success"};
  }
  ++bad_updates_;
  complaint_ = fmt::format("Faulty update for behavior: {}. Bad parameter(s): {}", name(), names);
  return {.result = "param_error", .complaint = reasons};
}

void HostedBehavior::Rebuild(const ConfigBlock& block, const BehaviorUpdate& update) {
  std::vector<std::string> keys;
  std::ranges::transform(update.parts, std::back_inserter(keys), &ConfigEntry::key);
  std::vector<ConfigProblem> problems;  // none: the parts were tried
  CommonSettings settings = ReadCommonSettings(block, problems);
  const bool are_conditions_new = std::ranges::any_of(
      keys, [](const std::string& key) { return EqualsIgnoringCase(key, "condition"); });
  if (!are_conditions_new) {
    settings.conditions = std::move(settings_.conditions);  // they remember what they have seen
  }
  settings.name = settings_.name;
  const bool are_own_keys_new = std::ranges::any_of(keys, [](const std::string& key) {
    return std::ranges::none_of(CommonBehaviorKeys(), [&key](const std::string& common) {
      return EqualsIgnoringCase(common, key);
    });
  });
  if (are_own_keys_new) {
    std::unique_ptr<Behavior> fresh;
    std::vector<std::string> variables;
    bool has_taken_over = false;
    if (!Call([&] { fresh = Make(block), variables = fresh->Variables(); })) return;
    Call([&] { has_taken_over = fresh->TakeOver(*behavior_, keys); });
    needs_start_ = !has_taken_over;
    behavior_ = std::move(fresh);
    own_variables_ = std::move(variables);
  }
  settings_ = std::move(settings);
  clock_.SetSettings(settings_.duration);
  block_ = block;
  are_config_flags_due_ = true;
}

}  // namespace limpet
