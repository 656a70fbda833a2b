// SPDX-License-Identifier: MIT
#include "limpet/helm/behavior_host.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "limpet/helm/all_flags.hpp"
#include "limpet/helm/behavior_host_warnings.hpp"

namespace limpet {

BehaviorHost::BehaviorHost(const std::vector<BehaviorFile>& files, RealClock clock)
    : clock_(std::move(clock)) {
  std::vector<ConfigProblem> problems;
  std::vector<ModeDeclaration> modes;
  for (const BehaviorFile& file : files) {
    initializes_.insert(initializes_.end(), file.initializes.begin(), file.initializes.end());
    modes.insert(modes.end(), file.modes.begin(), file.modes.end());
    for (const ConfigBlock& block : file.behaviors) {
      AddBehavior(block, problems);
    }
  }
  if (!problems.empty()) {
    throw ConfigError(problems);
  }
  modes_ = std::make_unique<ModeSet>(std::move(modes));
  RefreshStatuses();
}

void BehaviorHost::AddBehavior(const ConfigBlock& block, std::vector<ConfigProblem>& problems) {
  try {
    auto hosted = std::make_unique<HostedBehavior>(block, clock_);
    const CommonSettings& settings = hosted->settings();
    if (settings.templating != Templating::kDisallow) {
      if (settings.updates_variable.empty()) {
        problems.push_back({block.where, "templating", "needs `updates`, whose mail makes them"});
      }
      templates_.Add(block, settings);
      NoteRequest(*hosted);
    }
    if (settings.templating != Templating::kSpawn) {
      Adopt(std::move(hosted), "helm_startup");
    }
  } catch (const ConfigError& error) {
    problems.insert(problems.end(), error.problems().begin(), error.problems().end());
  }
}

void BehaviorHost::NoteRequest(const HostedBehavior& hosted) {
  std::optional<BehaviorPost> request;
  Heard(hosted.name(), failures_,
        [&] { request = hosted.behavior().Request(hosted.settings().updates_variable); });
  if (request) requests_.push_back({request->variable, request->value, hosted.name()});
}

void BehaviorHost::NoteLines(const HostedBehavior& hosted) {
  const auto warn = [&](const WarningFamily& family, const std::string& text) {
    block_warnings_.push_back({hosted.name(), {family.Of(hosted.name()), text}});
  };
  std::string keys, values;
  for (const ConfigProblem& line : hosted.IgnoredLines()) {
    keys += (keys.empty() ? "" : ", ") + line.key;
  }
  for (const ConfigProblem& line : hosted.AlteredLines()) {
    values += fmt::format("{}{}: {}", values.empty() ? "" : "; ", line.key, line.text);
  }
  if (!keys.empty()) warn(warnings::kBehaviorKeys, "without effect: " + keys);
  if (!values.empty()) warn(warnings::kBehaviorValues, values);
}

void BehaviorHost::Adopt(std::unique_ptr<HostedBehavior> hosted, std::string seed) {
  NoteLines(*hosted);
  events_.push_back({.kind = LifeEvent::Kind::kSpawn,
                     .name = hosted->name(),
                     .type = hosted->type(),
                     .seed = std::move(seed)});
  hosted_.push_back(std::move(hosted));
}

std::vector<std::string> BehaviorHost::Variables() const {
  std::set<std::string> names;
  const auto add = [&names](const std::vector<std::string>& more) {
    names.insert(more.begin(), more.end());
  };
  add(modes_->Variables());
  add(templates_.Variables());
  for (const auto& hosted : hosted_) {
    add(hosted->Variables());
  }
  return {names.begin(), names.end()};
}

std::vector<ConfigProblem> BehaviorHost::IgnoredLines() const {
  std::vector<ConfigProblem> lines;
  for (const auto& hosted : hosted_) {
    std::ranges::move(hosted->IgnoredLines(), std::back_inserter(lines));
    if (auto note = hosted->DurationNote()) lines.push_back(*std::move(note));
    std::ranges::move(hosted->AlteredLines(), std::back_inserter(lines));
  }
  return lines;
}

std::vector<std::string> BehaviorHost::PostedVariables() const {
  std::set<std::string> names;
  for (const auto& hosted : hosted_) {
    for (const auto* flags : AllFlags(hosted->settings().flags)) {
      for (const Flag& flag : *flags)
        names.insert(flag.variable);
    }
  }
  return {names.begin(), names.end()};
}

std::string BehaviorHost::UpdateVariables() const {
  std::string text;
  for (const auto& hosted : hosted_) {
    const std::string& variable = hosted->settings().updates_variable;
    if (variable.empty()) continue;
    text += fmt::format("{}{}={}", text.empty() ? "" : ",", hosted->name(), variable);
  }
  return text;
}

bool BehaviorHost::WantsView() const {
  return std::ranges::any_of(hosted_, [](const auto& hosted) { return hosted->WantsView(); });
}

std::vector<HelmPost> BehaviorHost::InitialPosts(Initials which) const {
  std::vector<HelmPost> posts;
  for (const InitialPost& initial : initializes_) {
    const bool is_wanted =
        initial.is_deferred ? !heard_.contains(initial.variable) : which == Initials::kAll;
    if (is_wanted) {
      posts.push_back({initial.variable, initial.value, "HELM_VAR_INIT"});
    }
  }
  posts.insert(posts.end(), requests_.begin(), requests_.end());
  return posts;
}

void BehaviorHost::SetVariable(const std::string& name, const Value& value, Seconds time) {
  heard_[name].Hear({time, value});
  const auto* text = std::get_if<std::string>(&value);
  if (text != nullptr && !text->empty()) {
    Spawn(name, *text);
  }
  bool is_updated = false;
  for (const auto& hosted : hosted_) {
    hosted->Hear(name, value);
    if (text == nullptr || text->empty() || hosted->settings().updates_variable != name) {
      continue;
    }
    std::erase_if(update_warnings_,
                  [&hosted](const OwnedWarning& old) { return old.owner == hosted->name(); });
    const UpdateOutcome outcome = hosted->ApplyUpdate(*text);
    if (outcome.complaint) {
      update_warnings_.push_back(
          {hosted->name(), {warnings::kBehaviorUpdate.Of(hosted->name()), *outcome.complaint}});
    }
    update_results_.push_back(
        fmt::format("bhv={},var={},time={:.2f},result={},val={}", hosted->name(), name,
                    (time - began_.value_or(time)).value(), outcome.result, *text));
    is_updated = true;
  }
  if (is_updated) {  // told also by a helm that stands still, for want of navigation
    RefreshStatuses();
  }
}

void BehaviorHost::Spawn(const std::string& variable, const std::string& text) {
  const auto is_taken = [this](const std::string& name) {
    return std::ranges::any_of(hosted_,
                               [&name](const auto& hosted) { return hosted->name() == name; });
  };
  for (SpawnRequest& request : templates_.RequestsOf(variable, text, is_taken)) {
    const std::string name = BehaviorNameOf(request.block), type = request.block.name;
    try {
      auto hosted = std::make_unique<HostedBehavior>(std::move(request.block), clock_);
      hosted->MarkSpawned(request.base_name);
      Adopt(std::move(hosted), text);
    } catch (const ConfigError& error) {
      events_.push_back(
          {.kind = LifeEvent::Kind::kAbort, .name = name, .type = type, .seed = text});
      update_warnings_.push_back({name, {warnings::kBehaviorUpdate.Of(name), error.what()}});
    }
  }
}

std::vector<OwnedWarning> BehaviorHost::warnings() const {
  std::vector<OwnedWarning> all = update_warnings_;
  all.insert(all.end(), block_warnings_.begin(), block_warnings_.end());
  return all;
}

const Value* BehaviorHost::Find(std::string_view name) const {
  if (const Value* mode = modes_->Find(name)) {
    return mode;
  }
  const auto found = heard_.find(name);
  return found == heard_.end() ? nullptr : &found->second.last().value;
}

std::vector<HelmPost> BehaviorHost::Update(const VehicleState& state) {
  began_ = began_.value_or(state.now);
  std::vector<HelmPost> posts;
  const auto lookup = [this](std::string_view name) { return Find(name); };
  mode_text_.clear();
  for (const ModeSet::Mode& mode : modes_->Evaluate(lookup, state.now)) {
    mode_text_ += (mode_text_.empty() ? "" : "#") + mode.variable + "@" + mode.value;
    if (mode.is_changed) {
      posts.push_back({mode.variable, mode.value, "HELM_MODE"});
    }
  }
  const ValueLookup find = lookup;
  HelmTurn turn{.state = state, .lookup = find, .filter = filter_, .posts = posts};
  running_.clear();
  for (const auto& hosted : hosted_) {
    hosted->Begin(turn);
    if (hosted->may_bid()) {
      running_.push_back({hosted->name(), hosted->settings().weight, &hosted->behavior()});
    }
  }
  RefreshStatuses();
  return posts;
}

std::vector<HelmPost> BehaviorHost::Settle(const IterationOutcome& outcome,
                                           const VehicleState& state) {
  std::vector<HelmPost> posts;
  const ValueLookup find = [this](std::string_view name) { return Find(name); };
  HelmTurn turn{.state = state, .lookup = find, .filter = filter_, .posts = posts};
  for (const auto& hosted : hosted_) {
    const auto done = std::ranges::find(outcome.turns, hosted->name(), &BehaviorTurn::name);
    const bool is_active =
        std::ranges::find(outcome.active, hosted->name()) != outcome.active.end();
    hosted->Settle(done == outcome.turns.end() ? std::span<const BehaviorAct>() : done->acts,
                   is_active, turn);
    std::ranges::move(hosted->TakeFailures(), std::back_inserter(failures_));
    std::ranges::move(hosted->TakeLateCalls(), std::back_inserter(late_calls_));
  }
  for (auto& [name, heard] : heard_) {
    heard.Settle();
  }
  RefreshStatuses();
  RemoveComplete();
  return posts;
}

std::vector<HelmPost> BehaviorHost::Retire(const VehicleState& state) {
  std::vector<HelmPost> posts;
  const ValueLookup find = [this](std::string_view name) { return Find(name); };
  HelmTurn turn{.state = state, .lookup = find, .filter = filter_, .posts = posts};
  for (const auto& hosted : hosted_) {
    hosted->Retire(turn);
    std::ranges::move(hosted->TakeFailures(), std::back_inserter(failures_));
    std::ranges::move(hosted->TakeLateCalls(), std::back_inserter(late_calls_));
  }
  return posts;
}

void BehaviorHost::RemoveComplete() {
  for (const auto& hosted : hosted_) {
    if (!hosted->is_complete()) continue;
    events_.push_back({.kind = LifeEvent::Kind::kDeath,
                       .name = hosted->name(),
                       .type = hosted->type(),
                       .reason = hosted->reason()});
    const auto is_its = [&hosted](const OwnedWarning& old) { return old.owner == hosted->name(); };
    std::erase_if(update_warnings_, is_its);
    std::erase_if(block_warnings_, is_its);
    std::erase_if(running_, [&hosted](const WeightedBehavior& running) {
      return running.behavior == &hosted->behavior();
    });
  }
  std::erase_if(hosted_, [](const auto& hosted) { return hosted->is_complete(); });
}

void BehaviorHost::RefreshStatuses() {
  statuses_.clear();
  for (const auto& hosted : hosted_) {
    statuses_.push_back(hosted->Status());
  }
}

}  // namespace limpet
