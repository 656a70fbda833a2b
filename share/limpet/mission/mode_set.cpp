// SPDX-License-Identifier: MIT
#include "limpet/mission/mode_set.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace limpet {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

std::string WithParent(const std::string& parent, const std::string& value) {
  return parent.empty() ? value : parent + ":" + value;
}

}  // namespace

ModeSet::ModeSet(std::vector<ModeDeclaration> declarations) {
  for (ModeDeclaration& declaration : declarations) {
    Entry entry{.declaration = std::move(declaration), .parent = "", .own_condition = kNone};
    const std::vector<Condition>& conditions = entry.declaration.conditions;
    for (std::size_t i = 0; i < conditions.size() && entry.own_condition == kNone; ++i) {
      const auto* plain = conditions[i].comparison();
      if (plain != nullptr && plain->op == "=" && plain->left == entry.declaration.variable) {
        entry.own_condition = i;
        entry.parent = plain->right;
      }
    }
    entries_.push_back(std::move(entry));
  }
}

std::vector<ModeSet::Mode> ModeSet::Evaluate(const ValueLookup& lookup, Seconds utc_now) {
  const auto before = values_;
  const ValueLookup with_modes = [this, &lookup](std::string_view variable) {
    const Value* mode = Find(variable);
    return mode != nullptr ? mode : lookup(variable);
  };
  for (Entry& entry : entries_) {
    std::vector<Condition>& conditions = entry.declaration.conditions;
    bool holds_all = true;
    bool holds_own = true;
    for (std::size_t i = 0; i < conditions.size(); ++i) {
      const bool holds = conditions[i].Holds(with_modes, utc_now);
      holds_all = holds_all && holds;
      holds_own = i == entry.own_condition ? holds : holds_own;
    }
    const std::string& value = holds_all   ? entry.declaration.value
                               : holds_own ? entry.declaration.else_value
                                           : std::string();
    if (!value.empty()) {
      values_[entry.declaration.variable] = WithParent(entry.parent, value);
    }
  }
  std::vector<Mode> modes;
  for (const auto& [variable, value] : values_) {
    const auto old = before.find(variable);
    modes.push_back(
        {variable, std::get<std::string>(value), old == before.end() || old->second != value});
  }
  return modes;
}

const Value* ModeSet::Find(std::string_view variable) const {
  const auto found = values_.find(variable);
  return found == values_.end() ? nullptr : &found->second;
}

std::vector<std::string> ModeSet::Variables() const {
  std::set<std::string> names;
  for (const Entry& entry : entries_) {
    for (const Condition& condition : entry.declaration.conditions) {
      for (std::string& name : condition.Variables()) {
        names.insert(std::move(name));
      }
    }
  }
  return {names.begin(), names.end()};
}

std::string ModeSet::Summary() const {
  std::vector<std::string> variables;
  for (const Entry& entry : entries_) {
    if (std::ranges::find(variables, entry.declaration.variable) == variables.end()) {
      variables.push_back(entry.declaration.variable);
    }
  }
  std::string summary;
  for (const std::string& variable : variables) {
    summary += (summary.empty() ? "" : "#") + variable;
    for (const Entry& entry : entries_) {
      for (const std::string& value : {entry.declaration.value, entry.declaration.else_value}) {
        if (entry.declaration.variable == variable && !value.empty()) {
          summary += "#" + (entry.parent.empty() ? "---" : entry.parent) + "," + value;
        }
      }
    }
  }
  return summary;
}

}  // namespace limpet
