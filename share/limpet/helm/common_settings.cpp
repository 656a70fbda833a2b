// SPDX-License-Identifier: MIT
#include "limpet/helm/common_settings.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <optional>

#include <fmt/format.h>

#include "limpet/core/number_text.hpp"
#include "limpet/helm/node_message.hpp"
#include "limpet/mission/behavior_file.hpp"

namespace limpet {
namespace {

/// Stores a line's value; the complaint if it is not allowed.
using Reader = std::function<std::optional<std::string>(const std::string& text, CommonSettings&)>;

struct CommonKey {
  std::vector<std::string> names;  ///< the first is the usual one
  Reader read;                     ///< absent: any value will do
  bool is_repeatable = false;
  bool is_without_effect = false;
};

std::string NotAllowed(const std::string& text, const char* allowed) {
  return fmt::format("`{}` is not allowed; allowed: {}", text, allowed);
}

bool HasBlank(std::string_view text) {
  return text.empty() || text.find_first_of(" \t") != std::string_view::npos;
}

std::optional<std::string> ReadWeight(const std::string& text, CommonSettings& settings) {
  const std::optional<double> weight = ParseNumber(text);
  if (!weight || *weight < 0.0) return NotAllowed(text, "at least 0");
  settings.weight = *weight;
  return std::nullopt;
}

std::optional<std::string> ReadCondition(const std::string& text, CommonSettings& settings) {
  Expected<Condition> condition = Condition::ParseWithCommas(text);
  if (!condition) return condition.error().text;
  settings.conditions.push_back(*std::move(condition));
  return std::nullopt;
}

std::optional<std::string> ReadDuration(const std::string& text, CommonSettings& settings) {
  const std::optional<double> limit = ParseNumber(text);
  const bool is_endless = EqualsIgnoringCase(text, "no-time-limit") || limit == -1.0;
  if (!is_endless && (!limit || *limit < 0.0)) {
    return NotAllowed(text, "seconds, at least 0, or no-time-limit");
  }
  settings.duration.limit = is_endless ? std::nullopt : std::optional<Seconds>(Seconds(*limit));
  return std::nullopt;
}

std::optional<std::string> ReadDurationReset(const std::string& text, CommonSettings& settings) {
  const std::size_t equals = text.find('=');
  const std::string variable(Trim(std::string_view(text).substr(0, equals)));
  if (HasBlank(variable)) return NotAllowed(text, "VARIABLE or VARIABLE=value");
  settings.duration.reset_variable = variable;
  settings.duration.reset_value =
      equals == std::string::npos ? "" : Trim(std::string_view(text).substr(equals + 1));
  return std::nullopt;
}

std::optional<std::string> ReadStarve(const std::string& text, CommonSettings& settings) {
  const std::vector<std::string> parts = Split(text, ',');
  const std::optional<double> oldest = ParseNumber(Trim(parts.back()));
  if (parts.size() < 2 || !oldest || *oldest <= 0.0) {
    return NotAllowed(text, "VARIABLE[, VARIABLE ...], seconds above 0");
  }
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    settings.starve_limits.push_back({std::string(Trim(parts[i])), Seconds(*oldest)});
  }
  return std::nullopt;
}

std::optional<std::string> ReadMapping(const std::string& text, CommonSettings& settings) {
  const std::vector<std::string> parts = Split(text, ',');
  if (parts.size() != 2 || HasBlank(Trim(parts[0])) || HasBlank(Trim(parts[1]))) {
    return NotAllowed(text, "VARIABLE, NEW_VARIABLE or VARIABLE, silent");
  }
  settings.post_mapping[std::string(Trim(parts[0]))] = Trim(parts[1]);
  return std::nullopt;
}

std::optional<std::string> ReadTemplating(const std::string& text, CommonSettings& settings) {
  constexpr std::array kKinds{
      std::pair{"disallow", Templating::kDisallow}, std::pair{"disallowed", Templating::kDisallow},
      std::pair{"spawn", Templating::kSpawn}, std::pair{"clone", Templating::kClone}};
  for (const auto& [name, kind] : kKinds) {
    if (EqualsIgnoringCase(text, name)) {
      settings.templating = kind;
      return std::nullopt;
    }
  }
  return NotAllowed(text, "disallow, spawn, clone");
}

std::optional<std::string> ReadMaxSpawnings(const std::string& text, CommonSettings& settings) {
  const std::optional<std::int64_t> count = ParseInteger(text);
  constexpr std::int64_t kMost = 1'000'000;
  if (!count || *count < 0 || *count > kMost) return NotAllowed(text, "0 to 1000000");
  settings.max_spawnings = static_cast<int>(*count);
  return std::nullopt;
}

Reader FlagTo(std::vector<Flag> FlagLists::*list) {
  return [list](const std::string& text, CommonSettings& settings) -> std::optional<std::string> {
    std::vector<Flag>& flags = settings.flags.*list;
    if (EqualsIgnoringCase(text, "clearall")) {
      flags.clear();
      return std::nullopt;
    }
    Expected<Flag> flag = Flag::Parse(text);
    if (!flag) return flag.error().text;
    if (!IsKnownDestination(*flag)) {
      return fmt::format("`#{}` is not supported; supported: #all, #all+, #group, #group+",
                         flag->group);
    }
    flag->has_parenthesis_macros = true;
    flags.push_back(*std::move(flag));
    return std::nullopt;
  };
}

std::optional<std::string> ReadUpdates(const std::string& text, CommonSettings& settings) {
  if (!text.empty() && HasBlank(text)) return NotAllowed(text, "one VARIABLE, without blanks");
  settings.updates_variable = text;
  return std::nullopt;
}

/// It has no effect here; a slip in it is one all the same.
std::optional<std::string> CheckPolicy(const std::string& text, CommonSettings&) {
  const std::vector<std::string> policies{"open", "lean", "dire"};
  const auto is_text = [&text](const auto& known) { return EqualsIgnoringCase(known, text); };
  if (std::ranges::any_of(policies, is_text)) return std::nullopt;
  const std::string nearest = NearestWord(text, policies);
  return NotAllowed(text, "open, lean, dire") +
         (nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest));
}

const std::vector<CommonKey>& Keys() {
  static const std::vector<CommonKey> keys{
      {{"name"}, [](const std::string&, CommonSettings&) { return std::nullopt; }},
      {{"pwt", "priority", "priwt"}, ReadWeight},
      {{"condition"}, ReadCondition, true},
      {{"runflag", "run_flag"}, FlagTo(&FlagLists::run), true},
      {{"runxflag", "runx_flag"}, FlagTo(&FlagLists::runx), true},
      {{"activeflag", "active_flag"}, FlagTo(&FlagLists::active), true},
      {{"inactiveflag", "inactive_flag"}, FlagTo(&FlagLists::inactive), true},
      {{"idleflag", "idle_flag"}, FlagTo(&FlagLists::idle), true},
      {{"endflag", "end_flag"}, FlagTo(&FlagLists::end), true},
      {{"spawnflag", "spawn_flag"}, FlagTo(&FlagLists::spawn), true},
      {{"spawnxflag", "spawnx_flag"}, FlagTo(&FlagLists::spawnx), true},
      {{"configflag", "config_flag"}, FlagTo(&FlagLists::config), true},
      {{"updates"}, ReadUpdates},
      {{"perpetual"},
       [](const std::string& text, CommonSettings& settings) -> std::optional<std::string> {
         const std::optional<bool> flag = ParseFlag(text);
         if (!flag) return NotAllowed(text, "true or false");
         settings.is_perpetual = *flag;
         return std::nullopt;
       }},
      {{"duration"}, ReadDuration},
      {{"duration_status"},
       [](const std::string& text, CommonSettings& settings) -> std::optional<std::string> {
         settings.duration.status_variable = text;
         return std::nullopt;
       }},
      {{"duration_reset"}, ReadDurationReset},
      {{"duration_idle_decay"},
       [](const std::string& text, CommonSettings& settings) -> std::optional<std::string> {
         const std::optional<bool> flag = ParseFlag(text);
         if (!flag) return NotAllowed(text, "true or false");
         settings.duration.counts_idle_time = *flag;
         return std::nullopt;
       }},
      {{"nostarve", "no_starve"}, ReadStarve, true},
      {{"post_mapping"}, ReadMapping, true},
      {{"templating"}, ReadTemplating},
      {{"max_spawnings"}, ReadMaxSpawnings},
      {{"comms_policy"}, CheckPolicy, false, true},
      {{"build_info"}, {}, true, true},
      {{"precision"}, {}, false, true}};
  return keys;
}

const CommonKey* FindKey(std::string_view key) {
  const auto found = std::ranges::find_if(Keys(), [key](const CommonKey& known) {
    return std::ranges::any_of(
        known.names, [key](const std::string& name) { return EqualsIgnoringCase(name, key); });
  });
  return found == Keys().end() ? nullptr : &*found;
}

}  // namespace

CommonSettings ReadCommonSettings(const ConfigBlock& block, std::vector<ConfigProblem>& problems) {
  CommonSettings settings;
  settings.name = BehaviorNameOf(block);
  if (settings.name.find("$(") != std::string::npos ||
      settings.name.find("%(") != std::string::npos) {
    const ConfigEntry* entry = block.Find("name");
    problems.push_back({entry != nullptr ? entry->where : block.where, "name",
                        fmt::format("`{}` is not allowed: it is a macro still", settings.name)});
  }
  for (const ConfigEntry& entry : block.entries) {
    const CommonKey* key = FindKey(entry.key);
    if (key == nullptr || !key->read) continue;
    if (const auto complaint = key->read(entry.value, settings)) {
      problems.push_back({entry.where, entry.key, *complaint});
    }
  }
  return settings;
}

const std::vector<std::string>& CommonBehaviorKeys() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const CommonKey& key : Keys()) {
      all.insert(all.end(), key.names.begin(), key.names.end());
    }
    return all;
  }();
  return names;
}

bool IsRepeatableCommonKey(std::string_view key) {
  const CommonKey* known = FindKey(key);
  return known != nullptr && known->is_repeatable;
}

bool IsIgnoredCommonKey(std::string_view key) {
  const CommonKey* known = FindKey(key);
  return known != nullptr && known->is_without_effect;
}

}  // namespace limpet
