// SPDX-License-Identifier: MIT
#include "apps/limpet/verbs/tune_live.hpp"

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "limpet/console/community.hpp"
#include "limpet/console/shown_text.hpp"
#include "limpet/console/tool_frame.hpp"
#include "limpet/core/host_name.hpp"
#include "limpet/core/letter_case.hpp"
#include "limpet/core/number_text.hpp"
#include "limpet/preflight/mission_reading.hpp"
#include "limpet/preflight/preflight.hpp"
#include "limpet/runs/session_runner.hpp"
#include "limpet/topics/tuning.hpp"
#include "limpet/topics/viewer.hpp"
#include "limpet/tuning/live_setting.hpp"
#include "limpet/tuning/tuned_place.hpp"

namespace limpet {
namespace {

namespace fs = std::filesystem;

/// `behavior.key=value`.
struct Wish {
  std::string name, value;
};

Wish WishIn(const std::string& word) {
  const std::size_t equals = word.find('='), dot = word.find('.');
  if (equals == std::string::npos || dot == std::string::npos || dot == 0 || dot + 1 >= equals) {
    throw UsageError(fmt::format("`{}` is no behavior.key=value", OneLine(word, 60)));
  }
  if (word.find('#', equals) != std::string::npos) {
    throw UsageError("a value with `#` cannot be sent: it parts the entries of an update");
  }
  return {.name = std::string(Trim(word.substr(0, equals))),
          .value = std::string(Trim(word.substr(equals + 1)))};
}

/// A behavior's parameter that can be changed while it runs.
TunedPlace LivePlace(const MissionReading& reading, const std::string& name) {
  TunedPlace place = FindTunedPlace(reading, name);
  if (!place.is_behavior) {
    throw UsageError(
        fmt::format("{} is an app: only behaviors take updates while they run", place.owner));
  }
  if (place.updates.empty()) {
    throw ConfigError({place.block, place.owner,
                       fmt::format("takes no updates: put e.g. `updates = {}_UPDATES` into its "
                                   "block and start the mission again",
                                   UpperCase(place.owner))});
  }
  return place;
}

/// What the community last said, by variable.
class LiveCommunity {
 public:
  LiveCommunity(const Arguments& given, const std::string& mission)
      : address_(AddressOf(given, mission)), community_(address_, OwnName("uTune")) {}

  /// The latest text of a variable, "" if there is none.
  [[nodiscard]] std::string Latest(const std::string& variable) const {
    const auto found = latest_.find(variable);
    return found == latest_.end() ? "" : found->second;
  }
  void Watch(const std::vector<std::string>& variables) {
    for (const std::string& variable : variables)
      community_.client().Subscribe(variable, Seconds(0.0));
    const auto mail = community_.Settle();
    if (!mail) {
      throw std::runtime_error(fmt::format("{} did not answer within {:g} s; nothing was changed",
                                           address_.Text(), address_.patience.value()));
    }
    Take(*mail);
  }
  void Write(const std::string& variable, const std::string& text) {
    community_.client().PublishValue(variable, text);
  }
  /// The behavior's count from a whole summary; asks the helm for one. Nothing if it does not
  /// answer in time, or no such behavior is there. `but_not`: waits for another count.
  [[nodiscard]] std::optional<UpdateCount> Count(
      const std::string& behavior, const std::optional<UpdateCount>& but_not = std::nullopt) {
    latest_.erase(topics::kHelmSummary.name);
    const auto until =
        std::chrono::steady_clock::now() + std::chrono::duration<double>(address_.patience.value());
    constexpr std::chrono::milliseconds kBetweenQuestions(500);
    auto asked = std::chrono::steady_clock::time_point{};
    while (std::chrono::steady_clock::now() < until) {
      if (std::chrono::steady_clock::now() - asked > kBetweenQuestions) {
        community_.client().Publish(topics::kHelmRejournal.name, 1.0);
        asked = std::chrono::steady_clock::now();
      }
      for (const Mail& mail : community_.TakeMail(Seconds(0.1))) {
        Take({mail});
        const auto count = UpdateCountIn(Latest(topics::kHelmSummary.name), behavior);
        if (count && count != but_not) return count;
      }
    }
    return std::nullopt;
  }
  /// All that was written is with the broker.
  void Settle() { static_cast<void>(community_.Settle()); }

 private:
  void Take(const std::vector<Mail>& mail) {
    for (const Mail& piece : mail) {
      if (const auto* text = std::get_if<std::string>(&piece.message.value)) {
        latest_[piece.message.name] = *text;
      }
    }
  }

  CommunityAddress address_;
  Community community_;
  std::map<std::string, std::string> latest_;
};

/// A mission, and the folder of its files.
struct ReadMissionFile {
  MissionFile mission;
  fs::path folder;

  explicit ReadMissionFile(const fs::path& file)
      : mission(LoadMission(file)),
        folder(file.has_parent_path() ? file.parent_path() : fs::path(".")) {}
};

/// What the mission's check says of a value; nothing if it is allowed.
std::optional<ConfigProblem> ProblemOf(const ReadMissionFile& read, const std::string& name,
                                       const std::string& value) {
  MissionFile changed = read.mission;
  ApplySetting(changed, name + "=" + value);
  const MissionProblems found = CheckLoadedMission(changed, read.folder);
  for (const auto* list : {&found.syntax, &found.refused_here}) {
    for (const ConfigProblem& problem : *list) {
      // Other problems of the mission did not keep it from running.
      if (problem.where.file.find(name) != std::string::npos) return problem;
    }
  }
  return std::nullopt;
}

/// The value in force: of what was sent the last that the helm applied, else what the mission says.
std::string ValueInForce(const LiveCommunity& community, const ReadMissionFile& read,
                         const TunedPlace& place, const std::optional<LiveEvent>& last) {
  const auto sent = UpdatedValue(community.Latest(place.updates), place.owner, place.key);
  const bool is_refused = sent && last && last->WasRefused(place.owner, place.key, *sent);
  if (sent && !is_refused && !ProblemOf(read, place.owner + "." + place.key, *sent)) return *sent;
  const auto set = last ? last->InForce(place.owner, place.key) : std::nullopt;
  return set.value_or(place.value);
}

std::optional<LiveEvent> LastEvent(const LiveCommunity& community) {
  const auto event = LiveEvent::FromText(community.Latest(topics::kTuneEvent.name));
  return event ? std::optional(*event) : std::nullopt;
}

/// Sends a change, waits for what the helm makes of it, and tells the community.
int Apply(LiveCommunity& community, const TunedPlace& place, LiveEvent event) {
  const LiveChange change = event.change;
  const std::string named = fmt::format("{}.{}", change.behavior, change.key);
  const std::optional<UpdateCount> before = community.Count(place.owner);
  if (!before) {
    fmt::print(stderr, "limpet tune: no helm says that behavior {} runs; nothing was changed\n",
               OneLine(place.owner));
    return kFailed;
  }
  community.Write(place.updates, UpdateText(change.behavior, change.key, change.new_value));
  const std::optional<UpdateCount> after = community.Count(place.owner, before);
  event.is_applied = after && after->good > before->good;
  if (event.is_undo) {
    if (event.is_applied) {
      event.undoable.pop_back();
    } else if (after) {
      event.DropRefusedUndo();
    }
  } else if (event.is_applied) {
    event.undoable.push_back(change);
    if (event.undoable.size() > LiveEvent::kMostUndoable) {
      event.undoable.erase(event.undoable.begin());
    }
  }
  community.Write(topics::kTuneEvent.name, event.Text());
  community.Settle();
  if (!event.is_applied) {
    fmt::print(stderr, "limpet tune: {}\n",
               OneLine(after ? fmt::format("the helm refused {} = {}: see PHELM_WARNINGS ({} of {} "
                                           "updates applied){}",
                                           named, change.new_value, after->good, after->all,
                                           event.is_undo ? "; it stays as it is, and the next "
                                                           "--undo takes back the change before"
                                                         : "")
                             : fmt::format("it is not known whether {} = {} was applied: the helm "
                                           "has not said so in time",
                                           named, change.new_value)));
    return kFailed;
  }
  fmt::print("{}\n", OneLine(fmt::format("{}: {} -> {}, applied ({} of {} updates good); {}@{}",
                                         named, change.old_value, change.new_value, after->good,
                                         after->all, event.user, event.host)));
  return kOk;
}

int Set(const Arguments& given, const fs::path& file, const std::string& word) {
  const Wish wish = WishIn(word);
  const ReadMissionFile read(file);
  const TunedPlace place = LivePlace(MissionReading(read.mission, read.folder), wish.name);
  if (const auto problem = ProblemOf(read, wish.name, wish.value)) throw ConfigError(*problem);
  LiveCommunity community(given, file.string());
  community.Watch({place.updates, topics::kTuneEvent.name, topics::kHelmSummary.name});
  const std::optional<LiveEvent> last = LastEvent(community);
  const std::string old_value = ValueInForce(community, read, place, last);
  if (old_value == wish.value) {
    fmt::print("{}\n", OneLine(fmt::format("{} is {} already", wish.name, wish.value)));
    return kOk;
  }
  return Apply(community, place,
               {.user = UserName(),
                .host = HostName().value_or("unknown"),
                .change = {.behavior = place.owner,
                           .key = place.key,
                           .old_value = old_value,
                           .new_value = wish.value},
                .undoable = last ? last->undoable : std::vector<LiveChange>{}});
}

int Undo(const Arguments& given, const fs::path& file) {
  const ReadMissionFile read(file);
  LiveCommunity community(given, file.string());
  community.Watch({topics::kTuneEvent.name, topics::kHelmSummary.name});
  const std::optional<LiveEvent> last = LastEvent(community);
  if (!last || last->undoable.empty()) {
    fmt::print(stderr, "limpet tune: nothing to undo in this community\n");
    return kFailed;
  }
  const LiveChange& done = last->undoable.back();
  const TunedPlace place =
      LivePlace(MissionReading(read.mission, read.folder), done.behavior + "." + done.key);
  community.Watch({place.updates});
  return Apply(community, place,
               {.user = UserName(),
                .host = HostName().value_or("unknown"),
                .is_undo = true,
                .change = {.behavior = done.behavior,
                           .key = done.key,
                           .old_value = ValueInForce(community, read, place, last),
                           .new_value = done.old_value},
                .undoable = last->undoable});
}

}  // namespace

int TuneLive(const Arguments& given) {
  const std::vector<std::string>& words = given.positionals();
  const std::size_t wanted = given.Has("undo") ? 1 : 2;
  if (words.size() != wanted) {
    throw UsageError(given.Has("undo") ? "--live --undo takes a mission and nothing else"
                                       : "--live takes a mission and one behavior.key=value");
  }
  const fs::path file = MissionFileAt(words[0]);
  try {
    return given.Has("undo") ? Undo(given, file) : Set(given, file, words[1]);
  } catch (const NoCommunity& error) {
    throw UsageError(error.what());
  }
}

}  // namespace limpet
