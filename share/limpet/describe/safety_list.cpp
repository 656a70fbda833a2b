// SPDX-License-Identifier: MIT
#include "limpet/describe/safety_list.hpp"

#include <fmt/format.h>

#include "limpet/describe/markdown_cell.hpp"
#include "limpet/safety/safety_params.hpp"

namespace limpet {
namespace {

constexpr const char* kSafetyPageHead = R"(# What endangers the vehicle, and what is done then

pSafety watches and says what is to be done, the highest of what its rules ask for:

| action | what it does |
| --- | --- |
| `none` | nothing |
| `warn` | says so: warning `TRIPPED_<rule>` |
| `degrade` | pPilot goes no faster than `degraded_speed_mps` |
| `hold` | pPilot keeps depth and heading without way on; the helm decides nothing (`Safety:hold`) |
| `return` | `RETURN = true`: pSurvey ends the survey and goes home; the helm brings it there |
| `surface` | pPilot thrusts upwards alone, without navigation not at all (a buoyant vehicle rises); the helm decides nothing; pSurvey ends the mission at the surface, aborted |
| `abort` | the same |

pPilot obeys `SAFETY_ACTION` by itself: a helm that hangs cannot keep the vehicle down. `MOOS_MANUAL_OVERRIDE` goes before it: then a person steers, or pLaunch brings it up.

A rule **trips** when what it watches has been beyond its limit for its hold time. `warn`, `degrade` and `hold` let go by themselves where the last column says so, once what the rule watches has been inside its limit (and its hysteresis) for so long; `return`, `surface` and `abort` stand until an operator writes `SAFETY_RESET = true`, after which what is still so trips anew. A rule that stands asks for no less in a later phase, but for `hold`, which lets go in a phase whose column does not ask for it. What is not known (nobody says it, or not now) neither trips nor clears. Of two rules the higher action is done. An action is said within 0.2 s of the end of the hold time, and again each second; pSafety started again takes up what it had said.

`SAFETY_STATE` has the action, the rule that asked first, since when, and every rule's margin: how far it is from its limit. Phases are those of `SURVEY_PHASE` (FIX counts as ascend); a mission without pSurvey is in `survey` once its helm has steered. Limits, hold times (`<rule>_hold_s`) and rules to do without (`off = <rule>`) are set in the block of pSafety; `limpet safety list <mission>` prints them as the mission has them. `limpet check` refuses limits that contradict the mission; `limpet safety test <mission>` flies faults in every phase and prints what was answered ([on table1](safety-results.md)). The silence of processes counts in real time, all else in vehicle time.

Generated: `limpet describe safety --markdown > docs/safety.md`.

| rule | watches | limit | after | idle | align | dive | survey | return | ascend | lets go after |
| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |
)";

std::string LimitText(const SafetyRule& rule, double limit) {
  if (rule.limit.key.empty()) return "";
  return fmt::format("{} {:g} {}", rule.side == SafetyRule::Side::kAbove ? "above" : "below", limit,
                     rule.limit.unit);
}

std::string LetsGoText(const SafetyRule& rule) {
  return rule.clears_after ? fmt::format("{:g} s", rule.clears_after->value()) : "reset";
}

}  // namespace

std::string SafetyRulesText(const SafetySettings& settings) {
  std::string text =
      fmt::format("{:<23}{:<17}{:<8}{:<9}{:<9}{:<9}{:<9}{:<9}{:<9}{}\n", "rule", "limit", "after",
                  "idle", "align", "dive", "survey", "return", "ascend", "lets go");
  for (const SafetyRule& rule : SafetyRules()) {
    const auto index = static_cast<std::size_t>(rule.id);
    text += fmt::format("{:<23}{:<17}", rule.name, LimitText(rule, settings.limits[index]));
    if (settings.is_off[index]) {
      text += "off\n";
      continue;
    }
    text += fmt::format("{:<8}", fmt::format("{:g} s", settings.holds[index].value()));
    for (const SafetyAction action : rule.actions) {
      text += fmt::format("{:<9}", action == SafetyAction::kNone ? "-" : NameOf(action));
    }
    text += LetsGoText(rule) + "\n";
  }
  return text;
}

std::string SafetyRulesMarkdown() {
  std::string page = kSafetyPageHead;
  for (const SafetyRule& rule : SafetyRules()) {
    const std::string key = rule.limit.key.empty() ? "" : fmt::format("`{}`: ", rule.limit.key);
    page += fmt::format("| `{}` | {} | {}{} | {:g} s |", rule.name, MarkdownCell(rule.meaning), key,
                        LimitText(rule, rule.limit.value), rule.hold.value());
    for (const SafetyAction action : rule.actions) {
      page += fmt::format(" {} |", action == SafetyAction::kNone ? "" : NameOf(action));
    }
    page += fmt::format(" {} |\n", LetsGoText(rule));
  }
  return page;
}

}  // namespace limpet
