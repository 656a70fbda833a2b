// SPDX-License-Identifier: MIT
#include "apps/limpet/describe/parameter_list.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "apps/limpet/describe/markdown_cell.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/helm/registry.hpp"

namespace limpet {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string DefaultOf(const ParamSpec& parameter) {
  if (parameter.is_required) return "required";
  const std::string text = parameter.default_text.empty() ? "(empty)" : parameter.default_text;
  return parameter.unit.empty() ? text : text + " " + parameter.unit;
}

std::string AllowedOf(const ParamSpec& parameter) {
  return parameter.is_repeatable ? parameter.allowed + " (may repeat)" : parameter.allowed;
}

OrderedJson JsonOf(const ParameterOwner& owner) {
  OrderedJson parameters = OrderedJson::array();
  for (const ParamSpec& parameter : owner.parameters) {
    parameters.push_back({{"name", parameter.name},
                          {"unit", parameter.unit},
                          {"default", parameter.is_required ? OrderedJson(nullptr)
                                                            : OrderedJson(parameter.default_text)},
                          {"required", parameter.is_required},
                          {"example", parameter.example},
                          {"allowed", parameter.allowed},
                          {"repeatable", parameter.is_repeatable},
                          {"meaning", parameter.help}});
  }
  OrderedJson out{{"name", owner.name}, {"kind", owner.is_app() ? "app" : "behavior"}};
  if (owner.is_app()) out["tick_hz"] = *owner.tick_hz;
  out["parameters"] = std::move(parameters);
  return out;
}

std::string MarkdownTable(const ParameterOwner& owner) {
  std::string page = fmt::format("\n### {}\n\n", owner.name);
  if (owner.is_app())
    page += fmt::format("Ticks at {} Hz unless AppTick says otherwise.\n\n", *owner.tick_hz);
  if (owner.parameters.empty()) return page + "No parameters of its own.\n";
  page += "| parameter | default | allowed | meaning |\n| --- | --- | --- | --- |\n";
  for (const ParamSpec& parameter : owner.parameters) {
    page +=
        fmt::format("| `{}` | {} | {} | {} |\n", parameter.name, MarkdownCell(DefaultOf(parameter)),
                    MarkdownCell(AllowedOf(parameter)), MarkdownCell(parameter.help));
  }
  return page;
}

}  // namespace

std::vector<ParameterOwner> AllParameterOwners() {
  std::vector<ParameterOwner> owners;
  for (const auto& [name, entry] : AppRegistry()) {
    owners.push_back(
        {.name = name, .tick_hz = entry.default_tick_hz, .parameters = entry.describe()});
  }
  for (const auto& [name, entry] : BehaviorRegistry()) {
    owners.push_back({.name = name, .tick_hz = {}, .parameters = entry.describe()});
  }
  return owners;
}

std::string PlainText(const ParameterOwner& owner) {
  std::string text = owner.is_app()
                         ? fmt::format("{}: app, ticks at {} Hz\n", owner.name, *owner.tick_hz)
                         : fmt::format("{}: behavior\n", owner.name);
  for (const ParamSpec& parameter : owner.parameters) {
    const std::string value = parameter.is_required ? ": required" : " = " + DefaultOf(parameter);
    text += fmt::format("\n  {}{}\n      {}\n      allowed: {}\n", parameter.name, value,
                        parameter.help, AllowedOf(parameter));
  }
  const auto& common = owner.is_app() ? CommonAppKeys() : CommonBehaviorKeys();
  return text + fmt::format("\n  and as every {}: {}\n", owner.is_app() ? "app" : "behavior",
                            fmt::join(common, ", "));
}

std::string Json(const std::vector<ParameterOwner>& owners) {
  OrderedJson list = OrderedJson::array();
  std::ranges::transform(owners, std::back_inserter(list), JsonOf);
  return list.dump(1) + "\n";
}

std::string Markdown(const std::vector<ParameterOwner>& owners) {
  std::string page =
      "# Parameters\n\nWhat the blocks of `mission.moos` (apps) and of `.bhv` files (behaviors) "
      "may "
      "set. Generated: `limpet describe parameters --markdown > docs/parameters.md`.\n";
  page += fmt::format("\n## Apps\n\nEvery app also takes MOOS's own keys: {}.\n",
                      fmt::join(CommonAppKeys(), ", "));
  for (const ParameterOwner& owner : owners) {
    if (owner.is_app()) page += MarkdownTable(owner);
  }
  page += fmt::format("\n## Behaviors\n\nEvery behavior also takes: {}.\n",
                      fmt::join(CommonBehaviorKeys(), ", "));
  for (const ParameterOwner& owner : owners) {
    if (!owner.is_app()) page += MarkdownTable(owner);
  }
  return page;
}

}  // namespace limpet
