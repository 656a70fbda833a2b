// SPDX-License-Identifier: MIT
#include "apps/pHelm/helm_journal.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limpet/core/decimal_text.hpp"
#include "limpet/topics/viewer.hpp"

namespace limpet {
namespace {

std::string DomainText(const std::vector<std::string>& lines) {
  std::string text;
  for (std::string line : lines) {
    std::ranges::replace(line, ':', ',');
    std::erase(line, ' ');
    text += (text.empty() ? "" : ":") + line;
  }
  return text;
}

/// `var=course:92.1,var=speed:0.5,var=depth:varbalk`
std::string DecisionText(const HelmIteration& iteration) {
  const auto text = [](const char* name, const std::optional<double>& value, int decimals) {
    return fmt::format("var={}:{}", name, value ? DecimalText(*value, decimals) : "varbalk");
  };
  return text("course", iteration.course_deg, 1) + "," + text("speed", iteration.speed, 2) + "," +
         text("depth", iteration.depth, 2);
}

/// `name$since[$pwt$pieces$cpu]$good/total[$functions]`, the brackets for those that bid.
std::string EntryText(const BehaviorStatus& behavior, Seconds since, bool is_active) {
  std::string text = fmt::format("{}${:.2f}", behavior.name, since.value());
  if (is_active) {
    text += fmt::format("${}$0$0", DecimalText(behavior.weight, 2));
  }
  text += fmt::format("${}/{}", behavior.good_updates, behavior.updates);
  return text + (is_active ? "$1" : "");
}

}  // namespace

const char* HelmJournal::NameOf(State state) {
  static constexpr const char* kNames[] = {"active", "running", "idle"};
  return kNames[static_cast<int>(state)];
}

HelmJournal::HelmJournal(const std::vector<std::string>& domain, Post post)
    : domain_(DomainText(domain)), post_(std::move(post)) {}

void HelmJournal::PostStart(const BehaviorHost& host, Seconds now) {
  const std::vector<BehaviorStatus> behaviors = host.Statuses();
  post_(topics::kHelmDomain.name, domain_);
  if (const std::string tree = host.ModeTree(); !tree.empty()) {
    post_(topics::kHelmModeSet.name, tree);
  }
  post_(topics::kHelmBehaviorCount.name, static_cast<double>(behaviors.size()));
  for (const BehaviorStatus& behavior : behaviors) {
    entries_[behavior.name] = {.state = State::kIdle, .since = now};
    post_(topics::kHelmLifeEvent.name,
          fmt::format("iter=0,time=0.00, bname={}, btype={}, event=spawn, seed=helm_startup,iter=1",
                      behavior.name, behavior.type));
  }
  std::string heard;
  for (const std::string& variable : host.Variables()) {
    post_(topics::kHelmRegister.name, variable);
    heard += (heard.empty() ? "" : ",") + variable;
  }
  post_(topics::kHelmStateVars.name, heard);
}

void HelmJournal::UpdateEntries(const HelmIteration& iteration) {
  for (const BehaviorStatus& behavior : iteration.behaviors) {
    const bool is_active =
        std::ranges::find(iteration.active, behavior.name) != iteration.active.end();
    const State state = !behavior.is_running ? State::kIdle
                        : is_active          ? State::kActive
                                             : State::kRunning;
    Entry& entry = entries_[behavior.name];
    if (entry.state != state) {
      entry = {.state = state, .since = iteration.now};
    }
  }
}

std::string HelmJournal::Described(const HelmIteration& iteration, State state) const {
  std::string text;
  for (const BehaviorStatus& behavior : iteration.behaviors) {
    if (const Entry& entry = entries_.at(behavior.name); entry.state == state) {
      text += (text.empty() ? "" : ":") + EntryText(behavior, entry.since, state == State::kActive);
    }
  }
  return text.empty() ? "none" : text;
}

std::string HelmJournal::Named(const HelmIteration& iteration, State state) const {
  std::string text;
  for (const BehaviorStatus& behavior : iteration.behaviors) {
    if (entries_.at(behavior.name).state == state) {
      text += (text.empty() ? "" : ",") + behavior.name;
    }
  }
  return text;
}

std::vector<std::pair<std::string, std::string>> HelmJournal::Fields(
    const HelmIteration& iteration) const {
  return {{"ofnum", fmt::format("ofnum={}", iteration.functions)},
          {"warnings", fmt::format("warnings={}", iteration.warnings)},
          {"decision", DecisionText(iteration)},
          {"halted", fmt::format("halted={}", iteration.is_halted)},
          {"modes", "modes=" + (iteration.modes.empty() ? "none" : iteration.modes)},
          {"running", "running_bhvs=" + Described(iteration, State::kRunning)},
          {"active", "active_bhvs=" + Described(iteration, State::kActive)},
          {"disabled", "disabled_bhvs=none"},
          {"idle", "idle_bhvs=" + Described(iteration, State::kIdle)},
          {"completed", "completed_bhvs=none"},
          {"domain", fmt::format("ivpdomain=\"{}\"", domain_)}};
}

void HelmJournal::PostIteration(const HelmIteration& iteration) {
  UpdateEntries(iteration);
  std::string summary =
      fmt::format("iter={},utc_time={:.2f}", iteration.number, iteration.now.value());
  for (const auto& [name, text] : Fields(iteration)) {
    if (std::string& last = summary_[name]; last != text) {
      summary += "," + text;
      last = text;
    }
  }
  post_(topics::kHelmIteration.name, static_cast<double>(iteration.number));
  post_(topics::kHelmSummary.name, summary);
  PostIfChanged(topics::kHelmActive.name, Named(iteration, State::kActive));
  PostIfChanged(topics::kHelmRunning.name, Named(iteration, State::kRunning));
  PostIfChanged(topics::kHelmIdle.name, Named(iteration, State::kIdle));
}

void HelmJournal::PostIfChanged(const std::string& variable, const std::string& text) {
  if (std::string& last = variables_[variable]; last != text) {
    last = text;
    post_(variable, text);
  }
}

}  // namespace limpet
