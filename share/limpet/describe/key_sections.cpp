// SPDX-License-Identifier: MIT
#include "limpet/describe/key_sections.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limpet/describe/markdown_cell.hpp"

namespace limpet {
namespace {

std::string DefaultWithUnit(const ParamSpec& key) {
  if (key.is_required) return "required";
  return key.unit.empty() ? key.default_text : key.default_text + " " + key.unit;
}

}  // namespace

std::string KeysText(const std::vector<KeySection>& sections) {
  std::string text;
  for (const KeySection& section : sections) {
    text += fmt::format("{}{}:\n", text.empty() ? "" : "\n", section.name);
    for (const ParamSpec& key : section.keys) {
      text +=
          fmt::format("\n  {}{}{}\n      {}\n      allowed: {}\n", key.name,
                      key.is_required ? ": " : " = ", DefaultWithUnit(key), key.help, key.allowed);
    }
  }
  return text;
}

std::string KeysJson(const std::vector<KeySection>& listed) {
  nlohmann::ordered_json sections = nlohmann::ordered_json::object();
  for (const KeySection& section : listed) {
    nlohmann::ordered_json& keys = sections[section.name] = nlohmann::ordered_json::array();
    for (const ParamSpec& key : section.keys) {
      keys.push_back({{"name", key.name},
                      {"unit", key.unit},
                      {"default", key.default_text},
                      {"allowed", key.allowed},
                      {"meaning", key.help}});
    }
  }
  return sections.dump(1) + "\n";
}

std::string KeysMarkdown(const std::vector<KeySection>& sections) {
  std::string page;
  for (const KeySection& section : sections) {
    page +=
        fmt::format("\n## {}\n\n| key | default | allowed | meaning |\n| --- | --- | --- | --- |\n",
                    section.name);
    for (const ParamSpec& key : section.keys) {
      page += fmt::format("| `{}` | {} | {} | {} |\n", key.name, MarkdownCell(DefaultWithUnit(key)),
                          MarkdownCell(key.allowed), MarkdownCell(key.help));
    }
  }
  return page;
}

}  // namespace limpet
