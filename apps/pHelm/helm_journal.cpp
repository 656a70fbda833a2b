// SPDX-License-Identifier: MIT
#include "apps/pHelm/helm_journal.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limpet/core/decimal_text.hpp"
#include "limpet/helm/motion_domain.hpp"
#include "limpet/topics/viewer.hpp"

namespace limpet {
namespace {

/// `var=course:92.1,var=speed:0.5,var=depth:varbalk`: no depth that is left to others.
std::string DecisionText(const HelmIteration& iteration, bool has_depth) {
  const auto text = [](const char* name, const std::optional<double>& value, int decimals) {
    return fmt::format("var={}:{}", name, value ? DecimalText(*value, decimals) : "varbalk");
  };
  return text("course", iteration.course_deg, 1) + "," + text("speed", iteration.speed, 2) +
         (has_depth ? "," + text("depth", iteration.depth, 2) : "");
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

/// `name=survey,pc=DEPLOY = true,state=idle,updates=n/a`.
std::string StatusText(const HelmJournal::Entry& entry) {
  const BehaviorStatus& behavior = entry.behavior;
  std::string text = "name=" + behavior.name;
  if (!behavior.held_back_by.empty()) text += ",pc=" + behavior.held_back_by;
  if (entry.state == HelmJournal::State::kActive) {
    text += ",pwt=" + DecimalText(behavior.weight, 2);
  }
  text += fmt::format(",state={},updates=", HelmJournal::NameOf(entry.state));
  return text + (behavior.takes_updates
                     ? fmt::format("{}/{}", behavior.good_updates, behavior.updates)
                     : std::string("n/a"));
}

}  // namespace

const char* HelmJournal::NameOf(State state) {
  static constexpr const char* kNames[] = {"active", "running", "idle", "completed"};
  return kNames[static_cast<int>(state)];
}

HelmJournal::HelmJournal(const std::vector<std::string>& domain, Post post)
    : domain_(MotionDomainText(domain)),
      has_depth_(domain.size() > 2),  // course and speed are always there
      post_(std::move(post)) {}

void HelmJournal::PostStart(const BehaviorHost& host, Seconds now) {
  const std::vector<BehaviorStatus>& behaviors = host.statuses();
  entries_.clear();
  summary_.clear();
  statuses_.clear();
  alive_ = 0;
  post_(topics::kHelmDomain.name, domain_);
  post_(topics::kHelmModeSet.name, host.ModeTree());  // also without modes
  post_(topics::kHelmDisabled.name, std::string());
  post_(topics::kHelmDisabledCount.name, 0.0);
  TellCompleted(0);
  started_ = now;
  for (const BehaviorStatus& behavior : behaviors) {
    entries_.push_back({.behavior = behavior, .state = State::kIdle, .since = now});
  }
  post_(topics::kHelmPiecesFormed.name, 0.0);
  post_(topics::kHelmPiecesCached.name, 0.0);
  for (const std::string& variable : host.Variables()) {
    post_(topics::kHelmRegister.name, variable);
  }
  PostVariables(host);
}

namespace {

HelmJournal::State StateOf(const BehaviorStatus& behavior, const HelmIteration& iteration) {
  if (behavior.is_complete) return HelmJournal::State::kComplete;
  if (!behavior.is_running) return HelmJournal::State::kIdle;
  const bool is_active =
      std::ranges::find(iteration.active, behavior.name) != iteration.active.end();
  return is_active ? HelmJournal::State::kActive : HelmJournal::State::kRunning;
}

}  // namespace

bool HelmJournal::UpdateEntries(const HelmIteration& iteration) {
  std::vector<Entry> entries;
  for (const BehaviorStatus& behavior : iteration.behaviors) {
    const State state = StateOf(behavior, iteration);
    const auto old = std::ranges::find_if(
        entries_, [&behavior](const Entry& entry) { return entry.behavior.name == behavior.name; });
    const bool stays = old != entries_.end() && old->state == state;
    const bool is_first_idle = old == entries_.end() && state == State::kIdle && entries_.empty();
    entries.push_back({.behavior = behavior,
                       .state = state,
                       .since = stays           ? old->since
                                : is_first_idle ? Seconds(0.0)
                                                : iteration.now});
  }
  const bool is_new = entries_ != entries;
  entries_ = std::move(entries);
  return is_new;
}

std::string HelmJournal::Described(State state) const {
  std::string text;
  for (const Entry& entry : entries_) {
    if (entry.state == state) {
      text += (text.empty() ? "" : ":") +
              EntryText(entry.behavior, entry.since, state == State::kActive);
    }
  }
  return text.empty() ? "none" : text;
}

std::string HelmJournal::Named(State state) const {
  std::string text;
  for (const Entry& entry : entries_) {
    if (entry.state == state) {
      text += (text.empty() ? "" : ",") + entry.behavior.name;
    }
  }
  return text;
}

void HelmJournal::AddField(const std::string& name, const std::string& text, std::string& summary) {
  if (std::string& last = summary_[name]; last != text) {
    summary += "," + text;
    last = text;
  }
}

void HelmJournal::PostIteration(const HelmIteration& iteration) {
  const bool is_whole = summary_.empty();
  const bool are_behaviors_new = UpdateEntries(iteration) || is_whole;
  std::string summary =
      fmt::format("iter={},utc_time={:.2f}", iteration.number, iteration.now.value());
  AddField("ofnum", fmt::format("ofnum={}", iteration.functions), summary);
  AddField("warnings", fmt::format("warnings={}", iteration.warnings), summary);
  AddField("decision", DecisionText(iteration, has_depth_), summary);
  AddField("halted", iteration.is_halted ? "halted=true" : "halted=false", summary);
  AddField("modes", fmt::format("modes={}", iteration.modes.empty() ? "none" : iteration.modes),
           summary);
  if (are_behaviors_new) {  // rarely; the rest is written ten times a second
    AddField("running", "running_bhvs=" + Described(State::kRunning), summary);
    AddField("active", "active_bhvs=" + Described(State::kActive), summary);
    AddField("disabled", "disabled_bhvs=none", summary);
    AddField("idle", "idle_bhvs=" + Described(State::kIdle), summary);
    AddField("completed", "completed_bhvs=" + Described(State::kComplete), summary);
    AddField("domain", fmt::format("ivpdomain=\"{}\"", domain_), summary);
  }
  post_(topics::kHelmIteration.name, static_cast<double>(iteration.number));
  post_(topics::kHelmSummary.name, std::move(summary));
  if (std::exchange(functions_, iteration.functions) != iteration.functions) {
    post_(topics::kHelmFunctionCount.name, static_cast<double>(iteration.functions));
  }
  if (are_behaviors_new) {
    PostStatuses();
    PostNames(topics::kHelmActive.name, topics::kHelmActiveCount.name, State::kActive);
    PostNames(topics::kHelmRunning.name, topics::kHelmRunningCount.name, State::kRunning);
    PostNames(topics::kHelmIdle.name, topics::kHelmIdleCount.name, State::kIdle);
  }
}

void HelmJournal::PostStatuses() {
  for (const Entry& entry : entries_) {
    const std::string text = StatusText(entry);
    if (std::string& last = statuses_[entry.behavior.name]; last != text) {
      last = text;
      post_(topics::kBehaviorStatus.name, text);
    }
  }
}

void HelmJournal::PostLifeEvents(std::span<const LifeEvent> events, std::int64_t iteration,
                                 Seconds now) {
  constexpr const char* kKinds[] = {"spawn", "abort", "death"};
  const int alive = alive_, made = made_;
  int completed = 0;
  for (const LifeEvent& event : events) {
    alive_ += event.kind == LifeEvent::Kind::kSpawn   ? 1
              : event.kind == LifeEvent::Kind::kDeath ? -1
                                                      : 0;
    completed += event.kind == LifeEvent::Kind::kDeath ? 1 : 0;
    made_ += event.kind == LifeEvent::Kind::kSpawn ? 1 : 0;
    const std::string seed = event.seed.empty() ? "" : ", seed=" + event.seed;
    const std::string reason = event.reason.empty() ? "" : ", post_mortem=" + event.reason;
    post_(topics::kHelmLifeEvent.name,
          fmt::format("iter=0,time={:.2f}, bname={}, btype={}, event={}{}{},iter={}",
                      (now - started_).value(), event.name, event.type,
                      kKinds[static_cast<int>(event.kind)], seed, reason, iteration));
  }
  if (alive_ != alive) post_(topics::kHelmBehaviorCount.name, static_cast<double>(alive_));
  if (made_ != made) post_(topics::kHelmBehaviorCountEver.name, static_cast<double>(made_));
  TellCompleted(completed);
}

void HelmJournal::TellCompleted(int count) {
  const bool is_pending = count > 0;
  if (std::exchange(completed_, count) == count) return;
  post_(topics::kHelmCompletedPending.name, std::string(is_pending ? "true" : "false"));
  post_(topics::kHelmCompletedCount.name, static_cast<double>(count));
}

void HelmJournal::PostPieces(int pieces) {
  if (std::exchange(pieces_, pieces) != pieces) {
    post_(topics::kHelmPiecesFormed.name, static_cast<double>(pieces));
  }
}

void HelmJournal::PostUpdateResults(std::span<const std::string> results) {
  for (const std::string& result : results)
    post_(topics::kHelmUpdateResult.name, result);
}

void HelmJournal::PostVariables(const BehaviorHost& host) {
  std::set<std::string> named;
  std::ranges::copy(host.Variables(), std::inserter(named, named.end()));
  std::ranges::copy(host.PostedVariables(), std::inserter(named, named.end()));
  std::string text = fmt::format("{}", fmt::join(named, ","));
  if (std::exchange(state_variables_, text) != text) {
    post_(topics::kHelmStateVars.name, std::move(text));
  }
  PostUpdateVariables(host.UpdateVariables());
}

void HelmJournal::PostUpdateVariables(const std::string& variables) {
  if (update_variables_ != variables) {
    update_variables_ = variables;
    post_(topics::kHelmUpdateVars.name, variables);
  }
}

void HelmJournal::PostNames(const std::string& variable, const std::string& count, State state) {
  const std::string names = Named(state);
  if (std::string& last = names_[state]; last != names) {
    last = names;
    post_(variable, names);
    post_(count, static_cast<double>(std::ranges::count(entries_, state, &Entry::state)));
  }
}

}  // namespace limpet
