// SPDX-License-Identifier: MIT
#include "limpet/runs/session_runner.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "limpet/app/embedded.hpp"
#include "limpet/app/registry.hpp"
#include "limpet/core/interrupt.hpp"
#include "limpet/mission/stand_ins.hpp"
#include "limpet/mission/vehicle_settings.hpp"
#include "limpet/runs/mission_check.hpp"
#include "limpet/runs/session_faults.hpp"
#include "limpet/survey/survey_params.hpp"
#include "limpet/topics/mission.hpp"
#include "limpet/topics/navigation.hpp"

namespace limpet {

namespace {

constexpr Seconds kDeployAfter(1.0);  // the helm has posted its initial values by then
constexpr double kLastMailSeconds =
    2.0;  // after the end is announced, so that the last save reaches the disk

constexpr Seconds kUnmanagedLongest(3.0 * 3600.0);
/// What the phases' bounds leave out: ticks, mail, saving.
constexpr Seconds kLongestMargin(120.0);

template <class T>
std::optional<T> LatestOf(const EmbeddedCommunity& community, const Topic<T>& topic) {
  const MessagePtr message = community.database().Latest(topic.name);
  return message != nullptr ? TopicCodec<T>::Decode(message->value) : std::nullopt;
}

/// Where the vehicle believes to be, in words.
std::string WhereaboutsIn(const EmbeddedCommunity& community) {
  std::string text = "phase " + LatestOf(community, topics::kSurveyPhase).value_or("not told");
  const auto nav = LatestOf(community, topics::kNavState);
  if (!nav) {
    return text + ", place unknown";
  }
  text += fmt::format(", north {:.1f}, east {:.1f} m, {:.1f} m deep", nav->north, nav->east,
                      std::max(0.0, nav->down));
  if (const auto home = LatestOf(community, topics::kSurveyHome)) {
    text += fmt::format(", {:.0f} m from home",
                        std::hypot(nav->north - home->north, nav->east - home->east));
  }
  return text;
}

EmbeddedSetup SetupFor(const MissionFile& mission, const SessionPlan& plan) {
  EmbeddedSetup setup{.community = mission.Global("Community"),
                      .apps = EmbeddedApps(mission),
                      .blocks = mission.blocks,
                      .globals = mission.globals,
                      .mission_folder = plan.mission_folder,
                      .run_folder = plan.run_folder,
                      .prior_folder = plan.prior_folder,
                      .session = plan.session,
                      .seed = plan.seed,
                      .may_hear = nullptr};
  if (!plan.delivers_truth_on_board) {
    setup.may_hear = [](const std::string& app, const std::string& variable) {
      return app.starts_with("uSim") || !variable.starts_with("SIM_");
    };
  }
  return setup;
}

}  // namespace

std::vector<std::string> EmbeddedApps(const MissionFile& mission) {
  static const std::vector<std::string> network_apps{
      "LimpetDB", "MOOSDB", "pShare", "pStation", "uScope", "uXMS", "pMarineViewer", "uMAC"};
  std::vector<std::string> apps;
  for (const LaunchEntry& launch : mission.launches) {
    if (std::ranges::find(network_apps, launch.binary) == network_apps.end()) {
      apps.push_back(launch.binary);
    }
  }
  return apps;
}

Seconds LongestSession(const MissionFile& mission) {
  const std::vector<std::string> apps = EmbeddedApps(mission);
  if (std::ranges::find(apps, "pSurvey") == apps.end()) {
    return kUnmanagedLongest;
  }
  return kDeployAfter + ReadAppParams<SurveyParams>(mission, "pSurvey").Longest() + kLongestMargin;
}

namespace {

/// `KEY=V` sets a global; what the vehicle's file says reaches the blocks anew.
void ApplyGlobal(MissionFile& mission, const std::string& setting, std::size_t equals) {
  const std::string key = setting.substr(0, equals);
  const SourceLine where{.file = "--set " + setting, .line = 0};
  const auto global = std::ranges::find_if(mission.globals, [&key](const ConfigEntry& entry) {
    return EqualsIgnoringCase(entry.key, key);
  });
  if (global == mission.globals.end()) {
    std::vector<std::string> known;
    std::ranges::transform(mission.globals, std::back_inserter(known), &ConfigEntry::key);
    const std::string nearest = NearestWord(key, known);
    throw ConfigError(
        {{},
         "--set",
         fmt::format("`{}` is neither app.key=value nor one of the mission's globals{}", setting,
                     nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest))});
  }
  const SourceLine former = global->where;
  *global = {global->key, setting.substr(equals + 1), where};
  for (ConfigBlock& block : mission.blocks) {
    for (ConfigEntry& entry : block.entries) {  // what the block took from the global
      const bool is_taken = entry.where.file == former.file && entry.where.line == former.line;
      if (is_taken) entry = {entry.key, global->value, where};
    }
  }
  TakeFacts(mission);
}

}  // namespace

void ApplySetting(MissionFile& mission, const std::string& setting) {
  const std::size_t dot = setting.find('.');
  const std::size_t equals = setting.find('=');
  if (equals != std::string::npos && equals > 0 && (dot == std::string::npos || dot > equals)) {
    ApplyGlobal(mission, setting, equals);
    return;
  }
  if (dot == std::string::npos || equals == std::string::npos) {
    throw ConfigError({{}, "--set", fmt::format("`{}` is not app.key=value", setting)});
  }
  const std::string owner = setting.substr(0, dot);
  ConfigEntry entry{.key = setting.substr(dot + 1, equals - dot - 1),
                    .value = setting.substr(equals + 1),
                    .where = {.file = "--set " + setting, .line = 0}};
  const bool is_app = AppRegistry().contains(owner);
  const std::string block_name = is_app ? owner : "pHelm";
  if (!is_app) {  // a behavior, by its name: the helm applies it to its .bhv file
    entry.value = owner + "." + entry.key + "=" + entry.value;
    entry.key = "behavior_setting";
  }
  auto block = std::ranges::find_if(
      mission.blocks, [&](const ConfigBlock& b) { return EqualsIgnoringCase(b.name, block_name); });
  if (block == mission.blocks.end()) {  // ours may run in a stock program's place, by its block
    block = std::ranges::find_if(mission.blocks, [&](const ConfigBlock& b) {
      return EqualsIgnoringCase(OwnNameOf(b.name), block_name);
    });
  }
  if (block == mission.blocks.end()) {
    mission.blocks.push_back({.name = block_name, .where = entry.where, .entries = {}});
    block = std::prev(mission.blocks.end());
  }
  if (is_app) {
    std::erase_if(block->entries,
                  [&](const ConfigEntry& old) { return EqualsIgnoringCase(old.key, entry.key); });
  }
  block->entries.push_back(std::move(entry));
  TakeFacts(mission);
}

SessionOutcome RunSession(const MissionFile& mission, const SessionPlan& plan,
                          const MessageObserver& observer) {
  const auto begin = std::chrono::steady_clock::now();
  std::filesystem::create_directories(plan.run_folder);
  SessionFaults faults(mission, plan.mission_folder);
  EmbeddedCommunity community(SetupFor(mission, plan));
  SessionOutcome outcome{.ended = "timeout", .duration = Seconds(0.0)};
  std::optional<Seconds> ended_at;
  community.Observe([&](const Message& message) {
    if (message.name == topics::kMissionEnd.name) {
      outcome.ended = std::get<std::string>(message.value);
      ended_at = message.time;
    }
    if (!faults.AreNone()) faults.Hear(message);
    observer(message);
  });
  while (community.elapsed() < kDeployAfter && !interrupt_requested) {
    community.Step();
  }
  community.Poke(topics::kDeploy.name, std::string("true"));
  const auto is_over = [&] {
    return ended_at && community.now() - *ended_at > Seconds(kLastMailSeconds);
  };
  const Seconds longest = plan.longest.value_or(LongestSession(mission));
  while (!is_over() && !interrupt_requested && community.elapsed() < longest) {
    if (!faults.AreNone()) faults.Apply(community);
    community.Step();
  }
  if (!ended_at) {
    outcome.ended = interrupt_requested ? "aborted" : "timeout";
    outcome.cut = fmt::format("{} after {:.0f} s: {}",
                              interrupt_requested ? "interrupted" : "cut, as too long,",
                              community.elapsed().value(), WhereaboutsIn(community));
  }
  community.Finish();
  outcome.duration = community.elapsed();
  outcome.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return outcome;
}

}  // namespace limpet
