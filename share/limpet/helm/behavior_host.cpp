// SPDX-License-Identifier: MIT
#include "limpet/helm/behavior_host.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"
#include "limpet/helm/behavior_update_warnings.hpp"
#include "limpet/helm/registry.hpp"

namespace limpet {

struct BehaviorHost::Hosted {
  ConfigBlock block;
  std::string name;
  double weight = 100.0;
  std::vector<Condition> conditions;
  std::vector<Flag> run_flags, running_flags, active_flags, inactive_flags, idle_flags;
  std::string updates_variable;
  std::string last_update;
  std::unique_ptr<Behavior> behavior;
  bool is_running = false;
  int good_updates = 0, updates = 0;

  [[nodiscard]] BehaviorStatus Status() const {
    return {.name = name,
            .type = block.name,
            .weight = weight,
            .is_running = is_running,
            .good_updates = good_updates,
            .updates = updates};
  }
};

void ApplyBehaviorSettings(std::vector<BehaviorFile>& files,
                           const std::vector<std::string>& settings) {
  for (const std::string& setting : settings) {
    const std::size_t dot = setting.find('.');
    const std::size_t equals = setting.find('=');
    const std::string name = setting.substr(0, dot);
    const SourceLine where{.file = "--set " + setting, .line = 0};
    std::vector<std::string> known;
    bool is_found = false;
    for (BehaviorFile& file : files) {
      for (ConfigBlock& block : file.behaviors) {
        known.push_back(BehaviorNameOf(block));
        if (known.back() == name) {
          const std::string key = setting.substr(dot + 1, equals - dot - 1);
          std::erase_if(block.entries,
                        [&key](const ConfigEntry& e) { return EqualsIgnoringCase(e.key, key); });
          block.entries.push_back({key, setting.substr(equals + 1), where});
          is_found = true;
        }
      }
    }
    if (!is_found) {
      throw ConfigError({where, name,
                         fmt::format("no app or behavior of this name; nearest behavior: `{}`",
                                     NearestWord(name, known))});
    }
  }
}

namespace {

bool IsWeight(std::string_view key) {
  return EqualsIgnoringCase(key, "pwt") || EqualsIgnoringCase(key, "priority");
}

/// Throws ConfigError.
double WeightFrom(const ConfigEntry& entry) {
  const std::optional<double> weight = ParseNumber(entry.value);
  if (!weight || *weight < 0.0) {
    throw ConfigError(
        ConfigProblem{entry.where, entry.key,
                      fmt::format("`{}` is not allowed; allowed: at least 0", entry.value)});
  }
  return *weight;
}

void AddFlag(const ConfigEntry& entry, std::vector<Flag>& flags,
             std::vector<ConfigProblem>& problems) {
  Expected<Flag> flag = Flag::Parse(entry.value);
  if (flag) {
    flags.push_back(*std::move(flag));
  } else {
    problems.push_back({entry.where, entry.key, flag.error().text});
  }
}

}  // namespace

BehaviorHost::BehaviorHost(const std::vector<BehaviorFile>& files) {
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
  for (const auto& hosted : hosted_) {
    statuses_.push_back(hosted->Status());
  }
}

BehaviorHost::~BehaviorHost() = default;

void BehaviorHost::AddBehavior(ConfigBlock block, std::vector<ConfigProblem>& problems) {
  auto hosted = std::make_unique<Hosted>();
  hosted->name = BehaviorNameOf(block);
  const auto entry = BehaviorRegistry().find(block.name);
  if (entry == BehaviorRegistry().end()) {
    std::vector<std::string> known;
    std::ranges::transform(BehaviorRegistry(), std::back_inserter(known),
                           [](const auto& registered) { return registered.first; });
    problems.push_back({block.where, "Behavior",
                        fmt::format("no behavior `{}`; nearest known: `{}`", block.name,
                                    NearestWord(block.name, known))});
    return;
  }
  const std::vector<std::pair<std::string_view, std::vector<Flag>*>> flag_keys{
      {"runflag", &hosted->run_flags},
      {"runxflag", &hosted->running_flags},
      {"activeflag", &hosted->active_flags},
      {"inactiveflag", &hosted->inactive_flags},
      {"idleflag", &hosted->idle_flags}};
  for (const ConfigEntry& e : block.entries) {
    const auto flags = std::ranges::find_if(
        flag_keys, [&e](const auto& known) { return EqualsIgnoringCase(e.key, known.first); });
    if (flags != flag_keys.end()) {
      AddFlag(e, *flags->second, problems);
    } else if (EqualsIgnoringCase(e.key, "condition")) {
      Expected<Condition> condition = Condition::Parse(e.value);
      if (condition) {
        hosted->conditions.push_back(*std::move(condition));
      } else {
        problems.push_back({e.where, e.key, condition.error().text});
      }
    } else if (IsWeight(e.key)) {
      try {
        hosted->weight = WeightFrom(e);
      } catch (const ConfigError& error) {
        problems.push_back(error.problems().front());
      }
    } else if (EqualsIgnoringCase(e.key, "updates")) {
      hosted->updates_variable = e.value;
    }
  }
  try {
    hosted->behavior = entry->second.create(block);
  } catch (const ConfigError& error) {
    problems.insert(problems.end(), error.problems().begin(), error.problems().end());
  }
  hosted->block = std::move(block);
  hosted_.push_back(std::move(hosted));
}

std::vector<std::string> BehaviorHost::Variables() const {
  std::set<std::string> names;
  const auto add = [&names](const std::vector<std::string>& more) {
    names.insert(more.begin(), more.end());
  };
  add(modes_->Variables());
  for (const auto& hosted : hosted_) {
    for (const Condition& condition : hosted->conditions) {
      add(condition.Variables());
    }
    if (!hosted->updates_variable.empty()) {
      names.insert(hosted->updates_variable);
    }
  }
  return {names.begin(), names.end()};
}

std::vector<HelmPost> BehaviorHost::InitialPosts() const {
  std::vector<HelmPost> posts;
  for (const InitialPost& initial : initializes_) {
    if (!initial.is_deferred || !variables_.contains(initial.variable)) {
      posts.push_back({initial.variable, initial.value, "HELM_VAR_INIT"});
    }
  }
  return posts;
}

void BehaviorHost::SetVariable(const std::string& name, const Value& value) {
  variables_.insert_or_assign(name, value);
  const auto* text = std::get_if<std::string>(&value);
  for (std::size_t i = 0; i < hosted_.size(); ++i) {
    Hosted& hosted = *hosted_[i];
    if (text != nullptr && !hosted.updates_variable.empty() && hosted.updates_variable == name &&
        hosted.last_update != *text) {
      hosted.last_update = *text;
      ApplyUpdate(hosted, *text);
      // Told also by a helm that stands still, for want of navigation.
      statuses_[i].good_updates = hosted.good_updates;
      statuses_[i].updates = hosted.updates;
    }
  }
}

void BehaviorHost::ApplyUpdate(Hosted& hosted, const std::string& text) {
  ConfigBlock updated = hosted.block;
  std::optional<ConfigEntry> weight;
  int parts = 0;
  const SourceLine where{.file = hosted.updates_variable, .line = 0};
  for (const std::string& part : Split(text, '#')) {
    const std::size_t equals = part.find('=');
    const std::string key(Trim(part.substr(0, equals)));
    const std::string value(
        equals == std::string::npos ? "" : Trim(std::string_view(part).substr(equals + 1)));
    if (key == "name") {
      if (value != hosted.name) {
        return;  // for another behavior
      }
      continue;
    }
    ++parts;
    if (IsWeight(key)) {
      weight = {key, value, where};
      continue;
    }
    std::erase_if(updated.entries,
                  [&key](const ConfigEntry& e) { return EqualsIgnoringCase(e.key, key); });
    updated.entries.push_back({key, value, where});
  }
  hosted.updates += parts;
  std::erase_if(warnings_, [&hosted](const OwnedWarning& old) { return old.owner == hosted.name; });
  try {
    const double new_weight = weight ? WeightFrom(*weight) : hosted.weight;
    hosted.behavior = BehaviorRegistry().at(updated.name).create(updated);
    hosted.weight = new_weight;
    hosted.block = std::move(updated);
    hosted.good_updates += parts;
    hosted.is_running = false;  // the new one is started like any other
  } catch (const ConfigError& error) {
    warnings_.push_back({hosted.name, {warnings::kBehaviorUpdate.Of(hosted.name), error.what()}});
  }
}

const Value* BehaviorHost::Find(std::string_view name) const {
  if (const Value* mode = modes_->Find(name)) {
    return mode;
  }
  const auto found = variables_.find(name);
  return found == variables_.end() ? nullptr : &found->second;
}

void BehaviorHost::PostFlags(const Hosted& hosted, const std::vector<Flag>& flags,
                             const VehicleState& state, std::vector<HelmPost>& posts) {
  const auto macros = [&](std::string_view name) -> std::optional<std::string> {
    if (name == "BHVNAME") return hosted.name;
    if (name == "BHVTYPE") return hosted.block.name;
    if (name == "UTC") return TextOf(state.now.value());
    if (name == "OSX") return TextOf(state.nav.east);
    if (name == "OSY") return TextOf(state.nav.north);
    return std::nullopt;
  };
  const auto lookup = [this](std::string_view name) { return Find(name); };
  for (const Flag& flag : flags) {
    std::optional<Condition> condition = flag.condition;
    if (!condition || condition->Holds(lookup, state.now)) {
      posts.push_back({flag.variable, flag.Resolve(macros), hosted.name});
    }
  }
}

void BehaviorHost::UpdateRunState(Hosted& hosted, const VehicleState& state,
                                  std::vector<HelmPost>& posts) {
  const auto lookup = [this](std::string_view name) { return Find(name); };
  const bool runs = std::ranges::all_of(
      hosted.conditions, [&](Condition& condition) { return condition.Holds(lookup, state.now); });
  if (runs && !hosted.is_running) {
    hosted.behavior->Start(state);
    PostFlags(hosted, hosted.run_flags, state, posts);
    PostFlags(hosted, hosted.active_flags, state, posts);
  } else if (!runs && hosted.is_running) {
    PostFlags(hosted, hosted.idle_flags, state, posts);
    PostFlags(hosted, hosted.inactive_flags, state, posts);
  }
  hosted.is_running = runs;
  if (runs) {
    PostFlags(hosted, hosted.running_flags, state, posts);
    running_.push_back({hosted.name, hosted.weight, hosted.behavior.get()});
  }
}

std::vector<HelmPost> BehaviorHost::Update(const VehicleState& state) {
  std::vector<HelmPost> posts;
  const auto lookup = [this](std::string_view name) { return Find(name); };
  mode_text_.clear();
  for (const ModeSet::Mode& mode : modes_->Evaluate(lookup, state.now)) {
    mode_text_ += (mode_text_.empty() ? "" : "#") + mode.variable + "@" + mode.value;
    if (mode.is_changed) {
      posts.push_back({mode.variable, mode.value, "HELM_MODE"});
    }
  }
  running_.clear();
  for (std::size_t i = 0; i < hosted_.size(); ++i) {
    const Hosted& hosted = *hosted_[i];
    UpdateRunState(*hosted_[i], state, posts);
    statuses_[i].weight = hosted.weight;
    statuses_[i].is_running = hosted.is_running;
    statuses_[i].good_updates = hosted.good_updates;
    statuses_[i].updates = hosted.updates;
  }
  return posts;
}

}  // namespace limpet
