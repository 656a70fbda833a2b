// SPDX-License-Identifier: MIT
#include "limpet/describe/warning_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "limpet/describe/markdown_cell.hpp"

namespace limpet {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr const char* kPageHead =
    R"(# Warnings and events

Every warning that apps and behaviors raise and every event that they report, from their declarations. Generated: `limpet describe warnings --markdown > docs/warnings.md`.

## Warnings

A warning stands until it clears. `<APP>_WARNINGS` tells `ID (severity): text; ...` or `none`: at once what is raised and cleared, and every 2 s (real time) what a text says anew. APPCAST shows what stands with its severity and since when, in seconds after the app's start; `limpet survey` tells it on the terminal, `report.json` and `report.html` list it. The helm raises those of behaviors (`BHV_*`). A name in angle brackets stands for what the warning is about.

- **note**: worth knowing; nothing has to be done.
- **warning**: something works less well than it should: look at it when you can.
- **alarm**: vehicle, mission or data are at stake: act now.

| warning | severity | raised by | meaning | what to do | clears |
| --- | --- | --- | --- | --- | --- |
)";

constexpr const char* kEventsHead = R"(
## Events

An event happens and is over. The last few of an app are in its report (APPCAST) as `[seconds after the app's start]: ID: text`; warnings raised and cleared are among them.

| event | severity | reported by | meaning |
| --- | --- | --- | --- |
)";

std::string Raisers(const std::vector<std::string>& raisers) {
  return raisers.empty() ? "every app" : fmt::format("{}", fmt::join(raisers, ", "));
}

std::string WarningText(const WarningDeclaration& warning) {
  const WarningFacts& facts = warning.facts;
  return fmt::format("{}: {}, raised by {}\n  meaning  {}\n  to do    {}\n  clears   {}\n",
                     warning.id, NameOf(facts.severity), Raisers(facts.raised_by), facts.meaning,
                     facts.action, facts.clears);
}

}  // namespace

std::string PlainText(const WarningList& list) {
  std::string text;
  for (const WarningDeclaration& warning : list.warnings) {
    text += (text.empty() ? "" : "\n") + WarningText(warning);
  }
  for (const auto& [id, facts] : list.events) {
    text +=
        fmt::format("{}{}: event, {}, reported by {}\n  meaning  {}\n", text.empty() ? "" : "\n",
                    id, NameOf(facts.severity), Raisers(facts.reported_by), facts.meaning);
  }
  return text;
}

std::string Json(const WarningList& list) {
  OrderedJson warnings = OrderedJson::array();
  for (const WarningDeclaration& warning : list.warnings) {
    const WarningFacts& facts = warning.facts;
    warnings.push_back({{"id", warning.id},
                        {"severity", NameOf(facts.severity)},
                        {"raised_by", facts.raised_by},
                        {"meaning", facts.meaning},
                        {"action", facts.action},
                        {"clears", facts.clears}});
  }
  OrderedJson events = OrderedJson::array();
  for (const auto& [id, facts] : list.events) {
    events.push_back({{"id", id},
                      {"severity", NameOf(facts.severity)},
                      {"reported_by", facts.reported_by},
                      {"meaning", facts.meaning}});
  }
  return OrderedJson{{"warnings", std::move(warnings)}, {"events", std::move(events)}}.dump(1) +
         "\n";
}

std::string Markdown(const WarningList& list) {
  std::string page = kPageHead;
  for (const WarningDeclaration& warning : list.warnings) {
    const WarningFacts& facts = warning.facts;
    page += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", warning.id, NameOf(facts.severity),
                        Raisers(facts.raised_by), MarkdownCell(facts.meaning),
                        MarkdownCell(facts.action), MarkdownCell(facts.clears));
  }
  page += kEventsHead;
  for (const auto& [id, facts] : list.events) {
    page += fmt::format("| `{}` | {} | {} | {} |\n", id, NameOf(facts.severity),
                        Raisers(facts.reported_by), MarkdownCell(facts.meaning));
  }
  return page;
}

}  // namespace limpet
