// SPDX-License-Identifier: MIT
#include "limpet/helm/node_message.hpp"

#include <algorithm>
#include <string_view>
#include <variant>

#include <fmt/format.h>

#include "limpet/core/decimal_text.hpp"
#include "limpet/topics/viewer.hpp"

namespace limpet {

std::string NodeMessage(const NodeSender& sender, const std::string& group, const HelmPost& post) {
  const std::string to = group.empty() ? "" : ",dest_group=" + group;
  const std::string text =
      fmt::format("src_node={},dest_node=all{},src_app=pHelm,src_bhv={},var_name={}", sender.node,
                  to, sender.behavior, post.variable);
  if (const auto* number = std::get_if<double>(&post.value)) {
    return text + ",double_val=" + DecimalText(*number, 8);
  }
  return text + ",string_val=\"" + std::get<std::string>(post.value) + "\"";
}

/// It is a field of a report like `NAME=alpha,GROUP=blue`, or that as JSON.
std::string OwnGroup(const VehicleState& state) {
  const Stamped<Value>* heard = state.Heard(topics::kNodeReportLocal.name);
  const auto* report = heard == nullptr ? nullptr : std::get_if<std::string>(&heard->value);
  if (report == nullptr) return "";
  std::string text = *report;
  std::erase_if(text, [](char c) { return c == '{' || c == '}' || c == '"'; });
  for (const std::string& field : Split(text, ',')) {
    const std::string_view written = field;
    const std::size_t mark = std::min(written.find_first_of("=:"), written.size());
    if (mark < written.size() && EqualsIgnoringCase(Trim(written.substr(0, mark)), "GROUP")) {
      return std::string(Trim(written.substr(mark + 1)));
    }
  }
  return "";
}

bool IsKnownDestination(const Flag& flag) {
  return flag.group.empty() || EqualsIgnoringCase(flag.group, "all") ||
         EqualsIgnoringCase(flag.group, "group");
}

bool HasGroupFlag(const ConfigEntry& line) {
  if (line.value.find('#') == std::string::npos) return false;
  const Expected<Flag> flag = Flag::Parse(line.value);
  return flag && EqualsIgnoringCase(flag->group, "group");
}

}  // namespace limpet
