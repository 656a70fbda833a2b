// SPDX-License-Identifier: MIT
#include "limpet/helm/act_list.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

#include "limpet/core/config.hpp"
#include "limpet/helm/node_message.hpp"

namespace limpet {

void ActList::Post(const std::string& variable, Value value, std::string key) {
  if (!variable.empty() && !EqualsIgnoringCase(variable, "silent")) {
    acts_.emplace_back(
        BehaviorPost{.variable = variable, .value = std::move(value), .key = std::move(key)});
  }
}

void ActList::Repeat(const std::string& variable, Value value) {
  if (!variable.empty() && !EqualsIgnoringCase(variable, "silent")) {
    acts_.emplace_back(
        BehaviorPost{.variable = variable, .value = std::move(value), .is_repeated = true});
  }
}

void ActList::Raise(std::span<const Flag> flags, const Behavior& behavior,
                    const VehicleState& state) {
  const std::size_t first = acts_.size();
  RaiseAgain(flags, behavior, state);
  for (BehaviorAct& act : std::span(acts_).subspan(first)) {
    std::get<Flag>(act).is_repeated = false;
  }
}

void ActList::RaiseAgain(std::span<const Flag> flags, const Behavior& behavior,
                         const VehicleState& state) {
  const auto own = [&](std::string_view name) { return behavior.Macro(name, state); };
  for (Flag flag : flags) {
    flag.text = ExpandRuntimeMacros(flag.text, own, flag.has_parenthesis_macros);
    acts_.emplace_back(std::move(flag));
  }
}

bool AddFlag(std::string_view text, std::vector<Flag>& flags) {
  if (EqualsIgnoringCase(text, "clearall")) {
    flags.clear();
    return true;
  }
  Expected<Flag> flag = Flag::Parse(text);
  if (!flag || !IsKnownDestination(*flag)) return false;
  flag->has_parenthesis_macros = true;
  flags.push_back(*std::move(flag));
  return true;
}

void DescribeFlags(ParamCollector& visit, const char* name, std::vector<Flag>& flags,
                   const char* help) {
  visit.ParsedLines(name, "VARIABLE = value", help,
                    [&flags](std::string_view text) { return AddFlag(text, flags); });
}

}  // namespace limpet
