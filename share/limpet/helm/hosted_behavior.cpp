// SPDX-License-Identifier: MIT
#include "limpet/helm/hosted_behavior.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "limpet/helm/all_flags.hpp"
#include "limpet/helm/behavior_failure_warnings.hpp"
#include "limpet/helm/behavior_names.hpp"
#include "limpet/helm/node_message.hpp"
#include "limpet/helm/registry.hpp"
#include "limpet/helm/settings_text.hpp"
#include "limpet/helm/toggled_switches.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/viewer.hpp"

namespace limpet {
namespace {

/// That there is no behavior of the block's name, and which is meant.
ConfigProblem UnknownBehavior(const ConfigBlock& block) {
  return {block.where, "Behavior",
          fmt::format("no behavior `{}`; {}; `limpet describe` lists those there are", block.name,
                      NearestBehaviorText(block.name))};
}

/// Problems that a behavior itself has found: at the line of their key, else of the block.
std::vector<ConfigProblem> Located(std::vector<ConfigProblem> problems, const ConfigBlock& block) {
  for (ConfigProblem& problem : problems) {
    if (!problem.where.file.empty()) continue;
    const ConfigEntry* entry = block.Find(problem.key);
    problem.where = entry == nullptr ? block.where : entry->where;
  }
  return problems;
}

}  // namespace

std::unique_ptr<Behavior> HostedBehavior::Make(const ConfigBlock& block) {
  const auto entry = BehaviorRegistry().find(block.name);
  if (entry == BehaviorRegistry().end()) throw ConfigError(UnknownBehavior(block));
  try {
    return entry->second.create(block);
  } catch (const ConfigError& error) {
    throw ConfigError(Located(error.problems(), block));
  } catch (...) {
    const auto failure = FailureOf(block.name, [] { throw; });
    throw ConfigError(ConfigProblem{block.where, "Behavior", failure->text});
  }
}

HostedBehavior::HostedBehavior(ConfigBlock block, RealClock clock)
    : block_(WithoutToggles(std::move(block))), watch_(std::move(clock)) {
  std::vector<ConfigProblem> problems;
  settings_ = ReadCommonSettings(block_, problems);
  try {
    behavior_ = Make(block_);
    if (!Call([this] { own_variables_ = behavior_->Variables(); })) {
      problems.push_back({block_.where, "Behavior", TakeFailures().front().text});
    }
  } catch (const ConfigError& error) {
    problems.insert(problems.end(), error.problems().begin(), error.problems().end());
  }
  if (!problems.empty()) {
    throw ConfigError(problems);
  }
  clock_.SetSettings(settings_.duration);
  if (const auto note = DurationNote()) complaint_ = name() + ": " + note->key + " " + note->text;
}

BehaviorStatus HostedBehavior::Status() const {
  return {.name = name(),
          .type = type(),
          .weight = settings_.weight,
          .is_running = is_running(),
          .is_complete = is_complete(),
          .held_back_by = is_complete() ? reason_ : held_back_by_,
          .takes_updates = !settings_.updates_variable.empty(),
          .good_updates = good_updates_,
          .updates = good_updates_ + bad_updates_};
}

bool HostedBehavior::WantsView() const {
  bool wants_view = false;
  // What it throws is told when it runs: it is asked again then.
  static_cast<void>(FailureOf(name(), [&] { wants_view = behavior_->WantsView(); }));
  return wants_view;
}

std::vector<std::string> HostedBehavior::Variables() const {
  std::vector<std::string> names = own_variables_;
  const auto add = [&names](const std::vector<std::string>& more) {
    names.insert(names.end(), more.begin(), more.end());
  };
  for (const Condition& condition : settings_.conditions) {
    add(condition.Variables());
  }
  for (const auto* flags : AllFlags(settings_.flags)) {
    for (const Flag& flag : *flags) {
      if (flag.condition) add(flag.condition->Variables());
    }
  }
  for (const StarveLimit& limit : settings_.starve_limits) {
    names.push_back(limit.variable);
  }
  if (std::ranges::any_of(block_.entries, HasGroupFlag)) {
    names.emplace_back(topics::kNodeReportLocal.name);
  }
  for (const std::string* variable :
       {&settings_.updates_variable, &settings_.duration.reset_variable}) {
    if (!variable->empty()) names.push_back(*variable);
  }
  return names;
}

std::vector<ConfigProblem> HostedBehavior::IgnoredLines() const {
  std::vector<ConfigProblem> lines =
      IgnoredKeys(block_, BehaviorRegistry().at(block_.name).describe());
  for (const ConfigEntry& entry : block_.entries) {
    if (IsIgnoredCommonKey(entry.key)) {
      lines.push_back({entry.where, entry.key, "has no effect in " + block_.name});
    }
  }
  return lines;
}

std::optional<ConfigProblem> HostedBehavior::DurationNote() const {
  if (!IsAskedForDuration(block_.name) || block_.Find("duration") != nullptr) return std::nullopt;
  return ConfigProblem{block_.where, "duration",
                       "is not said: no limit here, while pHelmIvP ends " + block_.name +
                           " at once; `no-time-limit` is right for both"};
}

std::vector<ConfigProblem> HostedBehavior::AlteredLines() const {
  return AlteredValues(block_, BehaviorRegistry().at(block_.name).describe());
}

std::string HostedBehavior::UnmetCondition(const HelmTurn& turn) {
  const auto unmet = std::ranges::find_if(settings_.conditions, [&turn](Condition& condition) {
    return !condition.Holds(turn.lookup, turn.state.now);
  });
  return unmet == settings_.conditions.end() ? "" : unmet->text();
}

std::string HostedBehavior::MissingInput(const HelmTurn& turn) const {
  const auto missing = std::ranges::find_if(settings_.starve_limits, [&turn](const auto& limit) {
    const Stamped<Value>* heard = turn.state.Heard(limit.variable);
    return heard == nullptr || turn.state.now - heard->time > limit.oldest;
  });
  if (missing == settings_.starve_limits.end()) return "";
  return fmt::format("VarStarve: {} (stime:{:g})", missing->variable, missing->oldest.value());
}

bool HostedBehavior::IsOver(HelmTurn& turn) {
  clock_.Begin(turn.state.now);
  PostTimeLeft(turn);
  const std::optional<Seconds> left = clock_.Remaining(turn.state.now);
  if (!left || *left > Seconds(0.0)) {
    return false;
  }
  Complete("completed-byduration", turn);
  if (is_complete()) return true;
  clock_.Reset();  // a perpetual one's next time runs from here, also while it is idle
  clock_.Begin(turn.state.now);
  return false;
}

void HostedBehavior::Begin(HelmTurn& turn) {
  if (std::exchange(are_spawn_flags_due_, false) && spawn_base_) {
    PostFlags(settings_.flags.spawn, turn);
  }
  if (!complaint_.empty()) {
    const std::string text = std::exchange(complaint_, "");
    Post({.variable = "BHV_WARNING", .value = text, .is_repeated = true}, turn);
    Post({.variable = "BHV_CONFIG_WARNING", .value = text, .is_repeated = true}, turn);
  }
  held_back_by_ = UnmetCondition(turn);
  if (held_back_by_.empty() && IsOver(turn)) {
    TellSettings(turn);
    End(turn);
    return;
  }
  TellSettings(turn);
  if (held_back_by_.empty()) held_back_by_ = MissingInput(turn);
  if (held_back_by_.empty()) {
    BeginRunning(turn);
  } else {
    BeginIdle(turn);
  }
}

void HostedBehavior::BeginRunning(HelmTurn& turn) {
  begins_to_run_ = state_ != State::kRunning;
  state_ = State::kRunning;
  if (begins_to_run_ || needs_start_) {
    needs_start_ = !Call([&] { behavior_->Start(turn.state); });  // or again next time
  }
}

void HostedBehavior::BeginIdle(HelmTurn& turn) {
  const State before = std::exchange(state_, State::kIdle);
  if (before != State::kIdle) {
    PostFlags(settings_.flags.idle, turn);
    PostFlags(settings_.flags.inactive, turn);
  }
  is_active_ = false;
  if (before == State::kRunning) End(turn);
  PerformIdle(turn);
  clock_.Spend(turn.state.now, false);
  if (std::exchange(are_spawnx_flags_due_, false)) PostFlags(settings_.flags.spawnx, turn);
}

void HostedBehavior::PerformIdle(HelmTurn& turn) {
  std::vector<BehaviorAct> acts;
  NoteLate(watch_.Ask(name(), [&] {
    static_cast<void>(Heard(name(), failures_, [&] { acts = behavior_->Idle(turn.state); }));
  }));
  Perform(acts, turn);
}

void HostedBehavior::NoteLate(const std::optional<std::string>& complaint) {
  if (!complaint) return;
  late_calls_.push_back(LatenessOf(name(), *complaint));
}

void HostedBehavior::Settle(std::span<const BehaviorAct> acts, bool is_active, HelmTurn& turn) {
  if (!is_running()) {
    return;
  }
  Perform(acts, turn);
  if (std::exchange(begins_to_run_, false)) PostFlags(settings_.flags.run, turn);
  PostFlags(settings_.flags.runx, turn);
  if (is_active != is_active_) {
    PostFlags(is_active ? settings_.flags.active : settings_.flags.inactive, turn);
  }
  is_active_ = is_active;
  clock_.Spend(turn.state.now, true);
  if (is_complete()) {
    End(turn);
  }
  if (std::exchange(are_spawnx_flags_due_, false)) PostFlags(settings_.flags.spawnx, turn);
}

void HostedBehavior::Complete(const std::string& reason, HelmTurn& turn) {
  PostFlags(settings_.flags.end, turn);
  Call([&] { behavior_->Complete(turn.state); });
  bool is_perpetual = settings_.is_perpetual;
  Call([&] { is_perpetual = is_perpetual || behavior_->IsPerpetual(); });
  if (!is_perpetual) {
    reason_ = reason;
    state_ = State::kComplete;
  }
}

void HostedBehavior::End(HelmTurn& turn) {
  std::vector<BehaviorAct> acts;
  Call([&] { acts = behavior_->Stop(turn.state); });
  Perform(acts, turn);
}

void HostedBehavior::Perform(std::span<const BehaviorAct> acts, HelmTurn& turn) {
  for (const BehaviorAct& act : acts) {
    if (const auto* post = std::get_if<BehaviorPost>(&act)) {
      Post(*post, turn);
    } else if (const auto* flag = std::get_if<Flag>(&act)) {
      PostFlag(*flag, turn);
    } else if (const auto* emergency = std::get_if<Emergency>(&act)) {
      Post({.variable = topics::kBehaviorError.name, .value = name() + ": " + emergency->reason},
           turn);
    } else if (!is_complete()) {
      Complete(std::get<Completion>(act).reason, turn);
    }
  }
}

void HostedBehavior::TellSettings(HelmTurn& turn) {
  if (!std::exchange(are_config_flags_due_, false)) return;
  const std::vector<ParamSpec> specs = BehaviorRegistry().at(block_.name).describe();
  Post({.variable = "BHV_SETTINGS",
        .value = SettingsText(block_, name(), specs),
        .is_repeated = true},
       turn);
  for (Flag flag : settings_.flags.config) {
    flag.is_repeated = false;
    PostFlag(flag, turn);
  }
}

void HostedBehavior::PostFlags(std::span<const Flag> flags, HelmTurn& turn) {
  for (const Flag& flag : flags) {
    PostFlag(flag, turn);
  }
}

void HostedBehavior::PostFlag(const Flag& flag, HelmTurn& turn) {
  std::optional<Condition> condition = flag.condition;
  if (condition && !condition->Holds(turn.lookup, turn.state.now)) {
    return;
  }
  const FlagOwner owner{.name = name(),
                        .type = type(),
                        .weight = settings_.weight,
                        .clock = clock_,
                        .behavior = *behavior_};
  const Value value = flag.Resolve([&](std::string_view macro) {
    std::optional<std::string> text;
    Call([&] { text = macros_.Expand(macro, owner, turn.state); });
    return text;
  });
  if (flag.is_also_local) {
    Post({.variable = flag.variable, .value = value, .is_repeated = flag.is_repeated}, turn);
  }
  if (!flag.group.empty()) {
    const std::string group =
        EqualsIgnoringCase(flag.group, "group") ? OwnGroup(turn.state) : std::string();
    turn.posts.push_back({"NODE_MESSAGE_LOCAL",
                          NodeMessage({.node = turn.state.ownship, .behavior = name()}, group,
                                      {flag.variable, value, name()}),
                          name()});
  }
}

void HostedBehavior::Post(const BehaviorPost& post, HelmTurn& turn) const {
  const auto mapped = settings_.post_mapping.find(post.variable);
  const std::string& variable =
      mapped == settings_.post_mapping.end() ? post.variable : mapped->second;
  if (!EqualsIgnoringCase(variable, "silent") && turn.filter.Passes(name(), post)) {
    turn.posts.push_back({variable, post.value, name()});
  }
}

void HostedBehavior::PostTimeLeft(HelmTurn& turn) {
  const std::string& variable = settings_.duration.status_variable;
  const std::optional<Seconds> left = clock_.Remaining(turn.state.now);
  if (variable.empty() || !left) {
    return;
  }
  constexpr Seconds kExactBelow(10.0);  // before that whole seconds do, and are posted more seldom
  const double seconds = *left > kExactBelow ? std::round(left->value()) : left->value();
  Post({.variable = variable, .value = seconds}, turn);
}

}  // namespace limpet
